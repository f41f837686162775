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
  tell(fmt::format("\r{} [{:#<{}}{: <{}}] {}/{}", label_, "", full, "", width - full, done, all));
}

void say(const std::string& what) {
  if (::isatty(STDERR_FILENO) != 1) return;
  tell("\r\033[K" + what);
}

void tell(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace wavecurve::tools
