#include "wavecurve/dynamics/detail/tolerance.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve::dynamics {

namespace {

void check(const char* name, double value) {
  if (value > 0 && std::isfinite(value)) return;
  throw std::invalid_argument(fmt::format("{} is {}, but must be finite and above 0", name, value));
}

}  // namespace

void check_tolerance(double tolerance) { check("tolerance", tolerance); }

void check_step(double step) { check("step", step); }

}  // namespace wavecurve::dynamics
