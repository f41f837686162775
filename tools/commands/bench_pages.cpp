#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <unistd.h>

#include <fmt/format.h>

#include "benchmarks/pages/history_page.hpp"
#include "benchmarks/pages/peers_page.hpp"
#include "tools/commands/commands.hpp"

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

void say(const std::string& what) {
  if (isatty(STDERR_FILENO) == 0) return;
  fmt::print(stderr, "\r\033[K{}", what);
  std::fflush(stderr);
}

void add_peers(CLI::App& bench) {
  auto build = std::make_shared<fs::path>(root / "build" / "release" / "bin");
  auto output = std::make_shared<fs::path>(root / "reports" / "latest");
  auto options = std::make_shared<PeersOptions>();
  CLI::App* command = bench.add_subcommand(
      "peers", "This library beside GSL, PyWavelets, mpmath, SUNDIALS and Odeint, as a page");
  command->add_option("build", *build, "Folder with all benchmark programs");
  command->add_option("--blocks", options->blocks, "Ours, peer, peer, ours, of each pair")
      ->check(CLI::Range(6, 1000))
      ->capture_default_str();
  command->add_option("-o,--output", *output, "Folder of peers.html")
      ->type_name("DIR")
      ->capture_default_str();
  command->callback([=] {
    reports::write_page(peers_page(build_in(*build), root, *options, say), *output, "peers");
    say("");
    fmt::print("page: {}\n", (*output / "peers.html").string());
  });
}

}  // namespace

void add_bench_pages(CLI::App& app) {
  CLI::App& bench = *app.get_subcommand("bench");
  add_history(bench);
  add_peers(bench);
}

}  // namespace wavecurve::tools
