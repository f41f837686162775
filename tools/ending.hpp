#pragma once

namespace wavecurve::tools {

/// How a program behaves towards signals and its standard streams. To be called first, before there
/// is another thread:
/// - SIGINT, SIGTERM and SIGHUP, unless whoever started the program ignores them, remove temporary
///   files and end child processes (io/files/detail/unfinished.hpp); then the program dies by the
///   same signal. A thread waits for them, so that nothing has to be done in a signal handler.
/// - Writing to a pipe that nobody reads is an error of that write, not the end of the program.
/// - A standard stream that is closed is opened to nothing, so that no file takes its number.
void prepare_for_ending();

/// Ends the program as one that writes to a pipe that nobody reads ends.
[[noreturn]] void die_of_broken_pipe();

/// Whether the reader of the standard output has gone.
bool is_output_pipe_broken();

}  // namespace wavecurve::tools
