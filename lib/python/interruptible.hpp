#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <pybind11/pybind11.h>
#include <thread>
#include <utility>

#include "wavecurve/certified/flint.hpp"

namespace wavecurve::python {

namespace py = pybind11;

/// Lets other Python threads run until the future is ready, and throws what Ctrl-C and other signals
/// raise.
template <class Result>
void wait_for(const std::future<Result>& future) {
  constexpr std::chrono::milliseconds patience{20};
  while (true) {
    {
      const py::gil_scoped_release release;
      if (future.wait_for(patience) == std::future_status::ready) return;
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

/// The result of work that may take long, computed on a thread of its own, so that Ctrl-C is
/// answered at once. Work that is interrupted ends by itself, and its result is dropped; so it owns
/// what it reads, and neither it nor its result may hold Python's objects or FLINT's numbers, whose
/// memory belongs to a thread.
template <class Work>
auto interruptible(Work work) -> decltype(work()) {
  using Result = decltype(work());
  auto task = std::make_shared<std::packaged_task<Result()>>(std::move(work));
  std::future<Result> future = task->get_future();
  std::thread worker([task = std::move(task)]() mutable {
    (*task)();
    task.reset();
    flint_cleanup();
  });
  try {
    wait_for(future);
  } catch (...) {
    worker.detach();
    throw;
  }
  {
    const py::gil_scoped_release release;
    worker.join();
  }
  return future.get();
}

}  // namespace wavecurve::python
