#pragma once

#include "tools/commands/commands.hpp"

namespace wavecurve::tools {

/// The program `wavecurve`: its name, its version and all commands. The manual pages and the
/// completions are made from the same definition.
void define_program(CLI::App& app, ExitCode& exit_code);

}  // namespace wavecurve::tools
