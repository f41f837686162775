#pragma once

/// A program that links this ends where memory is refused with one line and the exit code
/// environment_failed, too, where a std::bad_alloc has nowhere to go: before main, in a destructor,
/// or because there is no memory for an exception. (std::terminate does so; for any other exception it
/// aborts, as usual.)
namespace wavecurve::tools {

/// Says in one line that memory is used up, and takes none to do so.
void say_out_of_memory() noexcept;

/// Says so, and ends the program at once with the exit code environment_failed: for functions that
/// C calls, which may neither return nothing nor throw.
[[noreturn]] void end_out_of_memory() noexcept;

}  // namespace wavecurve::tools
