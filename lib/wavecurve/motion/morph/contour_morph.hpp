#pragma once

#include <Eigen/Core>

#include "wavecurve/motion/morph/morph.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve::motion {

/// The shares of a pair's details in the frame at a normalised time. Linear in tau but for the
/// stage's ends.
struct DetailShares {
  double source = 0, destination = 0;
};

/// At tau, 0 .. 1. Detail::stage: source max(0, 1 - tau / share), destination the same in
/// 1 - tau.
DetailShares detail_shares(Detail detail, double stage_share, double tau);

/// Throws std::invalid_argument for a share of a stage outside (0, 0.5].
void check_stage_share(double share);

/// Frames of corresponding contours, coefficients to points, of one transform and scale:
///   x(tau) = S [(1 - tau) A^s + tau A^d; source share D^s + destination share D^d],
/// A the first `scale` coefficients, D the others, S the synthesis matrix. Publication, (4.1).
/// Nothing is allocated by a frame; the workspace is the object's, so one object serves one thread.
class ContourMorph {
 public:
  /// Throws std::invalid_argument unless the scale is N / 2^l, l = 0 .. levels, and as
  /// PeriodicTransform does.
  ContourMorph(const FilterBank<double>& bank, Eigen::Index samples, int levels,
               Eigen::Index scale);

  /// Throws std::invalid_argument unless pair and points have the transform's number of rows.
  void frame(const ContourPair& pair, double tau, DetailShares shares, Eigen::Ref<Contour> points);

 private:
  PeriodicTransform<double> transform_;
  Eigen::Index scale_;
  Eigen::VectorXd coefficients_, workspace_;
};

}  // namespace wavecurve::motion
