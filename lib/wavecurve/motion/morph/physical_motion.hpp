#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "wavecurve/dynamics/lagrange_system.hpp"
#include "wavecurve/motion/animation.hpp"
#include "wavecurve/motion/morph/morph.hpp"

namespace wavecurve::motion {

/// The largest distance to its destination that a settled contour has left, as a share of the
/// longer side of the view box: a pixel of 500.
constexpr double settled_share = 0.002;

/// The material of a motion whose slowest mode swings over by a third, and back, while the stiffness damping
/// takes the fast ones out at once. The n-th mode swings n times a unit of time and has the damping
/// ratio pi n stiffness_damping (dynamics/lagrange_system.hpp).
constexpr dynamics::Material lively_material{.stiffness_damping = 0.1};

struct PhysicalOptions {
  dynamics::Material material = lively_material;
  /// A uniform force density, of units of the drawing (y down): it moves the mean alone.
  Eigen::RowVector2d force = Eigen::RowVector2d::Zero();
  std::optional<double> until{};    ///< length of the motion in units of its time; none: settled
  std::string solver = "spectral";  ///< a name of dynamics/solver.hpp
  int frames = 60;                  ///< keys at equal times
};

/// A morph as the motion of elastic contours, released at rest as the source, whose rest shape is
/// the destination: u = source - destination at time 0, publication, section 4.2. What no elastic
/// force brings back is prescribed: the mean of u goes to 0 in a straight line at constant speed
/// (Translation::interpolated), to which a force adds the arc on which the mean, thrown at the
/// beginning, is back at the end. Paint follows time as in the linear morph.
///
/// At a scale below the number of points the system is that of so many control points (coarse to
/// fine): the exact equation in the space of curves without details, which are added as the
/// linear morph adds them (Detail).
///
/// Solvers are made with the tolerance 1e-6, or with steps of 1 / 2048 of the motion. Throws
/// std::invalid_argument naming what is out of bounds, or the layer whose scale is not of its
/// transform; std::domain_error as settling_time, LagrangeSystem and the solver do, where the solver
/// stops, for a force on contours of density 0, and for more than 2^25 points in all frames together.
Animation physical_animation(const Morph& morph, const PhysicalOptions& options);

/// A time after which no control point of the exact motion is farther than settled_share from its
/// destination, but for the mean; at least one swing of the slowest mode. By the energy E, which
/// never grows: max |u|^2 <= 2 E (1 / scale) sum over n != 0 of 1 / k_n, k_n the eigenvalues of K
/// (Cauchy-Schwarz on the Fourier sum of u; max u^2 <= (1 / 12) int u'^2 without bending).
/// To 1 / 1000 of itself the first time for which this bound suffices. Throws std::domain_error
/// without damping or without elastic forces, and if it is beyond a million swings.
double settling_time(const Morph& morph, const dynamics::Material& material);

}  // namespace wavecurve::motion
