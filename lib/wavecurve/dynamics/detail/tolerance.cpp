#include "wavecurve/dynamics/detail/tolerance.hpp"

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::dynamics {

void check_tolerance(double tolerance) { check_above_zero("tolerance", tolerance); }

void check_step(double step) { check_above_zero("step", step); }

}  // namespace wavecurve::dynamics
