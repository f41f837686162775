#include "tools/commands/all_commands.hpp"

#include "tools/commands/version.hpp"

namespace wavecurve::tools {

void define_program(CLI::App& app, ExitCode& exit_code) {
  app.name("wavecurve");
  app.description(
      "Certified wavelet operators, and the verification of published wavelet numerics");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text,
                       "Print version, revision and libraries, and exit");
  add_filter_command(app, exit_code);
  add_coefficients_command(app, exit_code);
  add_check_command(app, exit_code);
  add_identify_command(app, exit_code);
  add_stiffness_command(app, exit_code);
  add_matrix_command(app, exit_code);
  add_morph_command(app, exit_code);
  add_describe_command(app, exit_code);
  add_distance_command(app, exit_code);
  add_reconstruct_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_gait_command(app, exit_code);
  add_bench_command(app, exit_code);
  add_bench_pages(app);
  add_verify_command(app, exit_code);
}

}  // namespace wavecurve::tools
