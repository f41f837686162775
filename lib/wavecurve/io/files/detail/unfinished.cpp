#include "wavecurve/io/files/detail/unfinished.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <set>
#include <sys/wait.h>
#include <system_error>
#include <thread>

namespace wavecurve::io {

namespace {

struct Registered {
  std::recursive_mutex mutex;
  std::set<std::filesystem::path> temporaries;
  std::set<pid_t> children;
};

/// Never destroyed: threads may still look while the program ends.
Registered& registered() {
  static Registered& all = *new Registered;
  return all;
}

/// A child that nobody has waited for yet keeps its number, so no other process is mistaken for it.
bool has_ended(pid_t child) {
  siginfo_t info{};
  const int flags = WEXITED | WNOHANG | WNOWAIT;
  return ::waitid(P_PID, static_cast<id_t>(child), &info, flags) != 0 || info.si_pid != 0;
}

void end_children(const std::set<pid_t>& children) {
  using namespace std::chrono_literals;
  for (const pid_t child : children) ::kill(-child, SIGTERM);
  for (auto waited = 0ms; waited < 2s && !std::ranges::all_of(children, has_ended); waited += 5ms) {
    std::this_thread::sleep_for(5ms);
  }
  for (const pid_t child : children) ::kill(-child, SIGKILL);
}

/// Twice, for the reason why it failed may have passed: no descriptor was free, say. What stays all
/// the same is removed by the next run.
void remove_wholly(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::remove_all(path, error);
  if (error) std::filesystem::remove_all(path, error);
}

}  // namespace

Unfinished::Unfinished() : lock_(registered().mutex) {}

void Unfinished::add(const std::filesystem::path& temporary) {
  registered().temporaries.insert(temporary);
}

void Unfinished::forget(const std::filesystem::path& temporary) {
  registered().temporaries.erase(temporary);
}

void Unfinished::add(pid_t child) { registered().children.insert(child); }

void Unfinished::forget(pid_t child) { registered().children.erase(child); }

void Unfinished::remove(const std::filesystem::path& temporary) {
  remove_wholly(temporary);
  forget(temporary);
}

void Unfinished::abandon() {
  end_children(registered().children);
  for (const std::filesystem::path& temporary : registered().temporaries) remove_wholly(temporary);
}

}  // namespace wavecurve::io
