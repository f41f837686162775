// `wavecurve bench` alone, without the library: for tools/bench.sh, which shall answer soon after a
// clone.
#include "tools/run_main.hpp"

namespace {

void define(CLI::App& app, wavecurve::tools::ExitCode& exit_code) {
  app.name("wavecurve");
  app.description("Tracks performance and accuracy (docs/how-to-read-benchmarks.md)");
  app.require_subcommand(1);
  wavecurve::tools::add_bench_command(app, exit_code);
}

}  // namespace

int main(int argc, char** argv) { return wavecurve::tools::run_main(argc, argv, define); }
