#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/io/files/detail/output_folder.hpp"

#include "benchmarks/pages/history_page.hpp"
#include "benchmarks/pages/peers_page.hpp"
#include "tools/commands/clone.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/input/number_option.hpp"
#include "tools/commands/progress.hpp"
#include "tools/commands/terminal.hpp"

namespace wavecurve::tools {

namespace {

namespace fs = std::filesystem;
using namespace tracking;

/// Writes NAME.html, and says so.
void write(const reports::Page& page, const fs::path& given, const std::string& name) {
  const fs::path folder = given_or_of_clone(given, "reports/latest");
  io::OutputFolder output(folder);
  reports::write_page(page, output.staging(), name);
  output.publish();
  fmt::print("page: {}\n", printable((folder / (name + ".html")).string()));
}

void add_history(CLI::App& bench) {
  auto history = std::make_shared<fs::path>();
  auto output = std::make_shared<fs::path>();
  CLI::App* command =
      bench.add_subcommand("history", "Charts over the records, change points marked, as a page");
  command
      ->add_option("--history", *history,
                   "Folder of the records; by default benchmarks/history of the clone")
      ->type_name("DIR");
  command
      ->add_option("-o,--output", *output,
                   "Folder of history.html; reports/latest of the clone if not given")
      ->type_name("DIR");
  command->callback([=] {
    const fs::path records = given_or_of_clone(*history, "benchmarks/history");
    const History read = read_history(records);
    for (const std::string& refusal : read.refused) {
      print_message("left out: " + refusal);
    }
    write(history_page(read.records, read_limit_reasons(records)), *output, "history");
  });
}

void add_peers(CLI::App& bench) {
  auto build = std::make_shared<fs::path>();
  auto output = std::make_shared<fs::path>();
  auto options = std::make_shared<PeersOptions>();
  CLI::App* command = bench.add_subcommand(
      "peers", "This library beside GSL, PyWavelets, mpmath, SUNDIALS and Odeint, as a page");
  command->add_option("build", *build,
                      "Folder with all benchmark programs; build/release/bin of the clone if not "
                      "given");
  command->add_option("--blocks", options->blocks, "Ours, peer, peer, ours, of each pair")
      ->check(whole_number_from(6, 1000))
      ->capture_default_str();
  command
      ->add_option("-o,--output", *output,
                   "Folder of peers.html; reports/latest of the clone if not given")
      ->type_name("DIR");
  command->callback([=] {
    const Build programs = build_in(given_or_of_clone(*build, "build/release/bin"));
    const reports::Page page = peers_page(programs, clone(), *options, say);
    say("");
    write(page, *output, "peers");
  });
}

}  // namespace

void add_bench_pages(CLI::App& app) {
  CLI::App& bench = *app.get_subcommand("bench");
  add_history(bench);
  add_peers(bench);
}

}  // namespace wavecurve::tools
