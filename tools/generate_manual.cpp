// Writes the manual pages and the completions of the program, as its own definition of commands has
// them: generate_manual DIR.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/all_commands.hpp"
#include "tools/manual/completions.hpp"
#include "tools/manual/man_page.hpp"

namespace {

void write_manual(const std::filesystem::path& folder) {
  using namespace wavecurve;
  CLI::App app;
  tools::ExitCode exit_code{};
  tools::define_program(app, exit_code);
  const tools::CommandText program = tools::command_text(app);
  std::filesystem::create_directories(folder);
  for (const tools::ManPage& page : tools::man_pages(program, WAVECURVE_VERSION)) {
    io::write_file(folder / page.file_name, page.text);
  }
  // The names under which each shell looks for them.
  io::write_file(folder / "wavecurve", tools::bash_completion(program));
  io::write_file(folder / "_wavecurve", tools::zsh_completion(program));
  io::write_file(folder / "wavecurve.fish", tools::fish_completion(program));
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fputs("usage: generate_manual DIR\n", stderr);
    return 2;
  }
  write_manual(argv[1]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "generate_manual: %s\n", error.what());
  return 3;
}
