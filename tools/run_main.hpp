#pragma once

#include "tools/commands/commands.hpp"

namespace wavecurve::tools {

/// The whole of a program's main function: prepares for signals (ending.hpp), defines its commands,
/// parses, runs, and turns what happens into an exit code. An exception becomes one line on the error
/// stream and
///   bad_input            for usage that the parser refuses, std::invalid_argument, std::domain_error
///   environment_failed   for std::system_error, std::bad_alloc and every other exception, and
///                        where the standard output cannot be written (a pipe that nobody reads
///                        ends it by SIGPIPE)
/// That the error stream cannot be written is no reason to stop.
using DefineCommands = void (*)(CLI::App& app, ExitCode& exit_code);
int run_main(int argc, char** argv, DefineCommands define);

}  // namespace wavecurve::tools
