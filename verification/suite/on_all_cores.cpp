#include "verification/suite/on_all_cores.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "wavecurve/certified/detail/thread_cache.hpp"

namespace wavecurve::verification {

void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t)>& finished) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex reporting;
  const auto run = [&] {
    const certified::ThreadCache cache;
    for (std::size_t i = next++; i < count; i = next++) {
      std::exception_ptr own;
      try {
        work(i);
      } catch (...) {
        own = std::current_exception();
      }
      const std::scoped_lock lock(reporting);
      if (failure) return;
      try {
        if (own) std::rethrow_exception(own);
        finished(i);
      } catch (...) {
        failure = std::current_exception();
        return;
      }
    }
  };
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> workers;
  for (std::size_t i = 0; i < std::min(cores, count); ++i) workers.emplace_back(run);
  workers.clear();  // joins
  if (failure) std::rethrow_exception(failure);
}

}  // namespace wavecurve::verification
