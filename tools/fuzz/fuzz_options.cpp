// The command lines of every command: one argument a line. No command is run.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/commands/all_commands.hpp"

namespace {

/// In the order in which the parser takes them, the last first.
std::vector<std::string> arguments(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    words.emplace(words.begin(), text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace wavecurve::tools;
  CLI::App app;
  ExitCode exit_code = done;
  define_program(app, exit_code);
  // Called when all options are read and checked, before any command runs.
  app.parse_complete_callback([] { throw CLI::Success(); });
  try {
    app.parse(arguments({reinterpret_cast<const char*>(bytes), size}));
  } catch (const CLI::Error&) {
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
