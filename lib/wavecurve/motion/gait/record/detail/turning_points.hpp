#pragma once

#include <vector>

#include <Eigen/Core>

namespace wavecurve::gait {

struct TurningPoint {
  double time = 0, value = 0;
  bool is_maximum = false;
};

/// Where a sampled function turns, maxima and minima by turns: the extremes between which it moves
/// by more than 0.4 of its range, so that noise and small detours do not count; a range that one
/// frame in twenty may exceed on either side. Neither end of the record is one.
/// The place is the vertex of the parabola that fits, by least squares, the neighbouring frames
/// whose value differs from the extreme by less than 0.1 of the range, at least one on either side.
std::vector<TurningPoint> turning_points(const Eigen::VectorXd& times,
                                         const Eigen::VectorXd& values);

}  // namespace wavecurve::gait
