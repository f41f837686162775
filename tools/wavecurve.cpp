#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>

#include "tools/commands/commands.hpp"

namespace {

using namespace wavecurve::tools;

/// One line on the error stream, whatever the message holds.
int complain(std::string message, ExitCode code) {
  for (char& c : message) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  std::fprintf(stderr, "wavecurve: %s\n", message.c_str());
  return code;
}

int run(int argc, char** argv) {
  CLI::App app("Certified wavelet operators, and the verification of published wavelet numerics",
               "wavecurve");
  app.require_subcommand(1);
  app.set_version_flag("--version", WAVECURVE_VERSION);
  ExitCode exit_code = done;
  add_filter_command(app, exit_code);
  add_coefficients_command(app, exit_code);
  add_check_command(app, exit_code);
  add_stiffness_command(app, exit_code);
  add_morph_command(app, exit_code);
  add_describe_command(app, exit_code);
  add_reconstruct_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_gait_command(app, exit_code);
  add_bench_command(app, exit_code);
  add_bench_pages(app);
  add_verify_command(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + " (wavecurve --help lists the commands)",
                    bad_input);
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return complain("cannot write to the standard output", environment_failed);
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::system_error& error) {
    return complain(error.what(), environment_failed);
  } catch (const std::invalid_argument& error) {
    return complain(error.what(), bad_input);
  } catch (const std::domain_error& error) {
    return complain(error.what(), bad_input);
  } catch (const std::exception& error) {
    return complain(error.what(), environment_failed);
  }
}
