// `wavecurve bench` alone, without the library: for tools/bench.sh, which shall answer soon after a
// clone.
#include <cstdio>
#include <exception>
#include <stdexcept>

#include "tools/commands/commands.hpp"

int main(int argc, char** argv) {
  using namespace wavecurve::tools;
  CLI::App app("Tracks performance and accuracy (docs/how-to-read-benchmarks.md)", "wavecurve");
  app.require_subcommand(1);
  ExitCode exit_code = done;
  add_bench_command(app, exit_code);
  try {
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "wavecurve: %s\n", error.what());
    return bad_input;
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "wavecurve: %s\n", error.what());
    return bad_input;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "wavecurve: %s\n", error.what());
    return environment_failed;
  }
}
