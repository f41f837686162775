#include "tools/commands/progress.hpp"

#include <cstdio>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

namespace wavecurve::tools {

Progress::Progress(std::string label)
    : label_(std::move(label)), is_terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (is_terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::size_t done, std::size_t all) {
  if (!is_terminal_ || all == 0) return;
  constexpr std::size_t width = 40;
  const std::size_t full = width * done / all;
  fmt::print(stderr, "\r{} [{:#<{}}{: <{}}] {}/{}", label_, "", full, "", width - full, done, all);
  std::fflush(stderr);
}

void say(const std::string& what) {
  if (::isatty(STDERR_FILENO) != 1) return;
  fmt::print(stderr, "\r\033[K{}", what);
  std::fflush(stderr);
}

}  // namespace wavecurve::tools
