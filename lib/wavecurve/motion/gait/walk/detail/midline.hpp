#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"

namespace wavecurve::gait {

/// The midline of a limb's outline, from where the limb hangs, its hinge, to the foot. The hinge is
/// the point opposite the foot, half the outline's length away; a node of the midline is in the
/// middle between the points that lie the same share of the way from hinge to foot on both sides.
class Midline {
 public:
  /// The midline of an outline at rest. Throws std::invalid_argument unless nodes >= 2, the foot is a point,
  /// and the outline has a length.
  Midline(const Contour& rest, Eigen::Index foot, int nodes = 32);

  Eigen::Index hinge() const { return hinge_; }
  Eigen::Index foot() const { return foot_; }
  /// The share of the way of each point of the outline, 0 at the hinge, 1 at the foot.
  const Eigen::VectorXd& shares() const { return shares_; }
  /// The nodes, hinge first, of an outline whose points are those of the one at rest.
  Contour nodes(const Contour& outline) const;

 private:
  struct Between {
    Eigen::Index point = 0, next = 0;
    double weight = 0;  ///< of the next
  };

  Eigen::Index hinge_, foot_;
  Eigen::VectorXd shares_;
  std::vector<std::array<Between, 2>> sides_;
};

}  // namespace wavecurve::gait
