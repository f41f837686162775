#pragma once

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::tracking {

/// An ellipse released towards the unit circle, D8, all levels, so many frames until t = 1.
dynamics::InitialValueProblem ellipse(Eigen::Index samples, Eigen::Index frames,
                                      dynamics::Material material = {});

}  // namespace wavecurve::tracking
