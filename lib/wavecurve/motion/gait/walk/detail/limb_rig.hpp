#pragma once

#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/motion/gait/walk/detail/midline.hpp"

namespace wavecurve::gait {

/// Lets a drawn limb move as a recorded one does, whatever its length, thickness and shape: each
/// piece of the drawn midline turns by the angle by which the recorded one has turned there since
/// the reference pose, the one that the drawing is taken for; points keep their places relative to
/// their piece of the midline. So lengths and widths stay, and the foot's way is scaled by the
/// limb's length. The hinge moves as the recorded one does, scaled too, but by less than 0.15 of
/// the limb's length (softly: tanh), for a drawn trunk does not stretch.
class LimbRig {
 public:
  /// The recorded limb in its reference pose, with its foot; the drawn one, of any number of
  /// points. Their points correspond by the shapes (best_shift), so both must look to the same
  /// side.
  LimbRig(const Contour& reference, Eigen::Index foot, const Contour& drawn);

  /// The points of the drawn limb in the recorded pose, the hinge where it is drawn.
  Contour pose(const Contour& recorded) const;
  /// From the reference pose on, in units of the drawing.
  Eigen::RowVector2d hinge_shift(const Contour& recorded) const;
  /// By how much, to the right, the foot is off the hinge, as a share of the limb's length.
  double drawn_lean() const;
  double recorded_lean(const Contour& recorded) const;

  /// The share of the way from hinge to foot of each drawn point.
  const Eigen::VectorXd& shares() const { return drawn_midline_.shares(); }
  Eigen::Index foot() const { return drawn_midline_.foot(); }
  const Contour& drawn() const { return drawn_; }
  double hinge_x() const { return drawn_nodes_(0, 0); }

 private:
  /// Where a drawn point is held by the midline.
  struct Hold {
    Eigen::Index piece = 0, turn = 0;  ///< between nodes, between pieces
    double share = 0, turn_share = 0;  ///< of the next one
    Eigen::RowVector2d offset;         ///< from there, at rest
  };

  Midline recorded_midline_;
  Contour reference_nodes_;
  Eigen::RowVector2d reference_hinge_;
  Contour drawn_;
  Midline drawn_midline_;
  Contour drawn_nodes_;
  double scale_;  ///< drawn over recorded length of the outline
  std::vector<Hold> holds_;
};

}  // namespace wavecurve::gait
