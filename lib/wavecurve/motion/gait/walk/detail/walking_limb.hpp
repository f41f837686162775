#pragma once

#include "wavecurve/motion/gait/model/detail/control_points.hpp"
#include "wavecurve/motion/gait/model/limb_path.hpp"
#include "wavecurve/motion/gait/walk/detail/limb_rig.hpp"
#include "wavecurve/motion/gait/walk/ground_contact.hpp"

namespace wavecurve::gait {

/// How the outline of a recorded limb is found at a share of the cycle.
struct RecordedLimb {
  LimbPath path;
  ControlPoints points;
  bool mirrored = false;  ///< left and right exchanged, and the order of points turned round
  Continuity continuity = Continuity::position;

  Contour outline(double u) const;
  Eigen::Index foot() const;  ///< the point of the outline
};

/// A drawn limb through the cycle, with its foot held to the ground while it stands.
///
/// Held: the limb is bent, in proportion to the share of the way from hinge to foot, by what its
/// foot differs from a point of the ground, and its lowest point from the height at which it is
/// drawn. In the swing, this reach goes from the one stance's end to the next one's beginning as a
/// cubic with the slopes that it has there, less what would go below the ground.
class WalkingLimb {
 public:
  struct State {
    Contour outline;
    Eigen::RowVector2d hinge_shift;  ///< off the mean of the cycle
  };

  /// The pose in which the limb is drawn is taken for that moment of the stance at which the
  /// recorded one leans as it does. Facing: of the drawing, and of the recorded limb as mirrored.
  WalkingLimb(RecordedLimb recorded, const Contour& drawn, double facing);

  /// The way of the foot relative to the body in a stance, over the stance's share of the cycle:
  /// what the ground would have to move by in a cycle for the foot not to slide.
  double own_stride() const { return own_stride_; }
  /// Until then the foot slides.
  void hold_to_ground(double stride);

  State at(double u) const;

  const LimbRig& rig() const { return rig_; }
  const CyclePart& contact() const { return contact_; }
  double stride() const { return stride_; }
  /// Where a foot on the ground is so long after touch-down (a share of the cycle).
  double ground_x(double since) const;
  double ground_y() const { return ground_y_; }
  /// The farthest from there without being held, in units of the drawing.
  double slide_before() const { return slide_before_; }

 private:
  State free(double u) const;
  /// What an outline lacks to stand on the ground.
  Eigen::RowVector2d lacking(const Contour& outline, double since) const;
  Eigen::RowVector2d reach(const Contour& outline, double u) const;

  RecordedLimb recorded_;
  double facing_;
  CyclePart contact_;
  LimbRig rig_;
  Eigen::RowVector2d mean_hinge_shift_ = Eigen::RowVector2d::Zero();
  double own_stride_ = 0, stride_ = 0, middle_x_ = 0, ground_y_ = 0, slide_before_ = 0;
  bool is_held_ = false;
  /// The reach at touch-down and at lift-off, with its slope by the share of the cycle.
  Eigen::RowVector2d down_, down_slope_, off_, off_slope_;
};

}  // namespace wavecurve::gait
