#include "tools/out_of_memory.hpp"

#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <unistd.h>

#include "tools/commands/commands.hpp"

namespace wavecurve::tools {

namespace {

/// Whether it is for want of memory that the program terminates. Without any exception it is: the
/// only other cause, a joinable std::thread that is destroyed, does not occur, since threads join.
bool lacks_memory() noexcept {
  const std::exception_ptr cause = std::current_exception();
  if (!cause) return true;
  try {
    std::rethrow_exception(cause);
  } catch (const std::bad_alloc&) {
    return true;
  } catch (...) {
    return false;
  }
}

[[noreturn]] void terminate() noexcept {
  if (lacks_memory()) end_out_of_memory();
  std::abort();
}

/// Before objects at namespace scope are made: those of CLI11 and the claims take memory.
[[gnu::constructor(101)]] void end_where_memory_terminates() noexcept {
  std::set_terminate(terminate);
}

}  // namespace

void say_out_of_memory() noexcept {
  constexpr std::string_view line = "wavecurve: out of memory\n";
  // Nothing can be done where even this is not written.
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
}

void end_out_of_memory() noexcept {
  say_out_of_memory();
  ::_exit(environment_failed);
}

}  // namespace wavecurve::tools
