#pragma once

#include <cstddef>
#include <functional>

namespace wavecurve::verification {

/// Does `work` for 0 .. count - 1 on all cores, lowest first, and after each of them `finished`,
/// which never runs on two threads at once. What either throws leaves the other threads without
/// further work, and is thrown again when they have ended.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t)>& finished);

}  // namespace wavecurve::verification
