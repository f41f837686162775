#pragma once

#include <Eigen/Core>

#include "wavecurve/dynamics/solver.hpp"

namespace wavecurve::dynamics {

/// What becomes of the mean of the displacement, a translation of the whole curve: it is in the
/// null space of K, so that no elastic force brings it back ("completely", as the publication has
/// it of its hoop, holds for displacements of mean zero only).
enum class Translation {
  free,          ///< as the equation has it: it stays, or moves on, or falls with the forces
  held,          ///< it stays where it is at time 0, whatever the forces
  interpolated,  ///< it goes in a straight line, at constant speed, to 0 at the last of the times
};

/// The solver with a translation of that kind. Unless free, the means of displacement, velocity and
/// forces are split off, the rest is solved, and the prescribed motion of the mean is added;
/// general forces see the whole motion, and their mean is split off too.
Solver with_translation(Solver solver, Translation translation);

/// The mean over the parameter of the curve that the coefficients describe, one value a coordinate.
Eigen::RowVectorXd mean(const LagrangeSystem& system,
                        const Eigen::Ref<const Eigen::MatrixXd>& coefficients);

}  // namespace wavecurve::dynamics
