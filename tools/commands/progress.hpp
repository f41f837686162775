#pragma once

#include <cstddef>
#include <string>

namespace wavecurve::tools {

/// A bar on the error stream, only if that is a terminal; it is wiped out at the end of its life.
class Progress {
 public:
  explicit Progress(std::string label);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::size_t done, std::size_t all);

 private:
  std::string label_;
  bool is_terminal_;
};

/// What a long command is doing, in place of what it was said to do before; only if the error
/// stream is a terminal.
void say(const std::string& what);

/// Writes to the error stream, as it is. If that cannot be written the work goes on all the same.
void tell(const std::string& text);

}  // namespace wavecurve::tools
