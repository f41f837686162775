#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "commands.hpp"
#include "history_page.hpp"

namespace wavecurve::tools {

namespace {

namespace fs = std::filesystem;
using namespace tracking;

const fs::path root = WAVECURVE_SOURCE_DIR;

void add_history(CLI::App& bench) {
  auto history = std::make_shared<fs::path>(root / "benchmarks" / "history");
  auto output = std::make_shared<fs::path>(root / "reports" / "latest");
  CLI::App* command =
      bench.add_subcommand("history", "Charts over the records, change points marked, as a page");
  command->add_option("--history", *history, "Folder of the records")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("-o,--output", *output, "Folder of history.html")
      ->type_name("DIR")
      ->capture_default_str();
  command->callback([=] {
    reports::write_page(history_page(read_history(*history)), *output, "history");
    fmt::print("page: {}\n", (*output / "history.html").string());
  });
}

}  // namespace

void add_bench_pages(CLI::App& app) {
  CLI::App& bench = *app.get_subcommand("bench");
  add_history(bench);
}

}  // namespace wavecurve::tools
