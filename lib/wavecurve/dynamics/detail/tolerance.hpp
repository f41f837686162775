#pragma once

namespace wavecurve::dynamics {

/// Throws std::invalid_argument unless the tolerance of a solver is finite and above 0.
void check_tolerance(double tolerance);

/// The same of a step size.
void check_step(double step);

}  // namespace wavecurve::dynamics
