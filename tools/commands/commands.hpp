#pragma once

#include <CLI/CLI.hpp>

namespace wavecurve::tools {

/// The exit codes of the command line.
enum ExitCode {
  done = 0,
  differs = 1,
  bad_input = 2,
  environment_failed = 3,
  inconclusive = 4,
  machines_differ = 5,
};

/// What they mean, for the manual and the README.
constexpr const char* exit_code_meanings[] = {
    "done, and as expected",
    "done, and something differs from what is blessed or demanded",
    "bad usage or bad input",
    "the environment failed: disk full, missing program",
    "bench: noise leaves it open whether something differs",
    "bench: what is to be compared comes from different machines",
};

// One function a subcommand, each in a file of its name. A command's callback writes its exit code
// if that is not `done`; it throws std::invalid_argument or std::domain_error for bad input and
// std::system_error where the environment fails.
void add_filter_command(CLI::App& app, ExitCode& exit_code);
void add_coefficients_command(CLI::App& app, ExitCode& exit_code);
void add_check_command(CLI::App& app, ExitCode& exit_code);
void add_identify_command(CLI::App& app, ExitCode& exit_code);
void add_stiffness_command(CLI::App& app, ExitCode& exit_code);
void add_matrix_command(CLI::App& app, ExitCode& exit_code);
void add_morph_command(CLI::App& app, ExitCode& exit_code);
void add_describe_command(CLI::App& app, ExitCode& exit_code);
void add_distance_command(CLI::App& app, ExitCode& exit_code);
void add_reconstruct_command(CLI::App& app, ExitCode& exit_code);
void add_compare_command(CLI::App& app, ExitCode& exit_code);
void add_gait_command(CLI::App& app, ExitCode& exit_code);
void add_bench_command(CLI::App& app, ExitCode& exit_code);
/// Its pages, which need the report's writer: added to `bench`, which is there already.
void add_bench_pages(CLI::App& app);
void add_verify_command(CLI::App& app, ExitCode& exit_code);

}  // namespace wavecurve::tools
