#include "verification/suite/on_all_cores.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "wavecurve/certified/detail/thread_cache.hpp"

namespace wavecurve::verification {

namespace {

/// Calls `finished` on one thread at a time, without letting the others wait for it: who finds it busy
/// leaves what it has to the one that is at it.
class Reporter {
 public:
  explicit Reporter(std::function<void(std::size_t)> finished) : finished_(std::move(finished)) {}

  void report(std::size_t i) {
    {
      const std::scoped_lock lock(access_);
      waiting_.push_back(i);
    }
    // Whatever comes after the last look, and finds the reporter busy, is seen by another look.
    while (has_waiting()) {
      const std::unique_lock reporting(reporting_, std::try_to_lock);
      if (!reporting.owns_lock()) return;
      for (std::vector<std::size_t> some = take(); !some.empty(); some = take()) {
        for (const std::size_t one : some) finished_(one);
      }
    }
  }

 private:
  bool has_waiting() {
    const std::scoped_lock lock(access_);
    return !waiting_.empty();
  }
  std::vector<std::size_t> take() {
    const std::scoped_lock lock(access_);
    return std::exchange(waiting_, {});
  }

  std::function<void(std::size_t)> finished_;
  std::mutex reporting_, access_;
  std::vector<std::size_t> waiting_;
};

}  // namespace

void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t)>& finished) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> has_failed = false;
  std::exception_ptr failure;
  std::mutex failing;
  const auto fail = [&] {
    const std::scoped_lock lock(failing);
    if (!has_failed.exchange(true)) failure = std::current_exception();
  };
  Reporter reporter([&](std::size_t i) {
    if (has_failed) return;
    try {
      finished(i);
    } catch (...) {
      fail();
    }
  });
  const auto run = [&] {
    const certified::ThreadCache cache;
    try {
      for (std::size_t i = next++; i < count && !has_failed; i = next++) {
        work(i);
        reporter.report(i);
      }
    } catch (...) {
      fail();
    }
  };
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> workers;
  for (std::size_t i = 0; i < std::min(cores, count); ++i) workers.emplace_back(run);
  workers.clear();  // joins
  if (failure) std::rethrow_exception(failure);
}

}  // namespace wavecurve::verification
