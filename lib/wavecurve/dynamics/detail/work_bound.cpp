#include "wavecurve/dynamics/detail/work_bound.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve::dynamics {

void check_work(long long operations, double time, double end) {
  const auto done = static_cast<double>(operations);
  if (done < most_operations / 50 || done * end <= most_operations * time) return;
  throw std::domain_error(fmt::format(
      "{:.2g} operations lead to time {:.4g} of {:.4g} only; all would be more than {:.2g}: the "
      "problem is too stiff or too large for this solver (spectral is exact and quick)",
      done, time, end, most_operations));
}

void check_work(long long operations) {
  if (static_cast<double>(operations) <= most_operations) return;
  throw std::domain_error(
      fmt::format("the solver takes more than {:.2g} operations", most_operations));
}

}  // namespace wavecurve::dynamics
