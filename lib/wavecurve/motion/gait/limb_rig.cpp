#include "wavecurve/motion/gait/limb_rig.hpp"

#include <algorithm>
#include <cmath>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/sample_contour.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;

constexpr double most_hinge_shift = 0.08;  ///< of the limb's length: a trunk does not stretch
constexpr Index around = 3;  ///< pieces of the midline on either side that turn with one

/// Of the open polygon.
double length(const Contour& nodes) {
  double sum = 0;
  for (Index i = 0; i + 1 < nodes.rows(); ++i) sum += (nodes.row(i + 1) - nodes.row(i)).norm();
  return sum;
}

double perimeter(const Contour& outline) {
  return length(outline) + (outline.row(0) - outline.row(outline.rows() - 1)).norm();
}

/// The share of the outline's length at which a point lies, from the first on.
double way_to(const Contour& outline, Index point) {
  double way = 0, whole = 0;
  for (Index i = 0; i < outline.rows(); ++i) {
    const double step = (outline.row((i + 1) % outline.rows()) - outline.row(i)).norm();
    if (i < point) way += step;
    whole += step;
  }
  return way / whole;
}

/// The drawn point that corresponds to the recorded foot. Drawn points are uniform in arc length.
Index drawn_foot(const Contour& reference, Index foot, const Contour& drawn) {
  const Contour uniform = sample_contour(reference, drawn.rows());
  const auto at =
      static_cast<Index>(std::lround(way_to(reference, foot) * static_cast<double>(drawn.rows())));
  return (at + best_shift(uniform, drawn)) % drawn.rows();
}

Eigen::RowVector2d turned(const Eigen::RowVector2d& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

}  // namespace

LimbRig::LimbRig(const Contour& reference, Index foot, const Contour& drawn)
    : recorded_midline_(reference, foot),
      reference_nodes_(recorded_midline_.nodes(reference)),
      reference_hinge_(reference_nodes_.row(0)),
      drawn_(drawn),
      drawn_midline_(drawn, drawn_foot(reference, foot, drawn)),
      drawn_nodes_(drawn_midline_.nodes(drawn)),
      scale_(perimeter(drawn) / perimeter(reference)) {}

Eigen::RowVector2d LimbRig::hinge_shift(const Contour& recorded) const {
  const Eigen::RowVector2d shift =
      scale_ * (recorded_midline_.nodes(recorded).row(0) - reference_hinge_);
  const double most = most_hinge_shift * length(drawn_nodes_);
  return most * (shift / most).array().tanh().matrix();
}

double LimbRig::drawn_lean() const {
  return (drawn_nodes_(drawn_nodes_.rows() - 1, 0) - drawn_nodes_(0, 0)) / length(drawn_nodes_);
}

double LimbRig::recorded_lean(const Contour& recorded) const {
  const Contour nodes = recorded_midline_.nodes(recorded);
  return (nodes(nodes.rows() - 1, 0) - nodes(0, 0)) / length(nodes);
}

Contour LimbRig::pose(const Contour& recorded) const {
  const Contour now = recorded_midline_.nodes(recorded);
  const Index pieces = now.rows() - 1;
  Eigen::VectorXd angle(pieces);
  Contour nodes(now.rows(), 2);
  nodes.row(0) = drawn_nodes_.row(0);
  for (Index i = 0; i < pieces; ++i) {
    // Over more than a piece, since an outline's pieces turn more roughly than the limb.
    const Index first = std::max<Index>(i - around, 0), last = std::min(i + 1 + around, pieces);
    const Eigen::RowVector2d before = reference_nodes_.row(last) - reference_nodes_.row(first);
    const Eigen::RowVector2d after = now.row(last) - now.row(first);
    angle[i] = std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
    nodes.row(i + 1) =
        nodes.row(i) + turned(drawn_nodes_.row(i + 1) - drawn_nodes_.row(i), angle[i]);
  }
  Contour points(drawn_.rows(), 2);
  for (Index p = 0; p < points.rows(); ++p) {
    const double share = drawn_midline_.shares()[p];
    const double place = share * static_cast<double>(pieces);
    const Index i = std::min(static_cast<Index>(place), pieces - 1);
    const double rest = place - static_cast<double>(i);
    const Eigen::RowVector2d was =
        (1 - rest) * drawn_nodes_.row(i) + rest * drawn_nodes_.row(i + 1);
    const Eigen::RowVector2d is = (1 - rest) * nodes.row(i) + rest * nodes.row(i + 1);
    // Between the middles of the pieces the angle is linear, so that the outline has no kinks.
    const double centre = std::clamp(place - 0.5, 0.0, static_cast<double>(pieces - 1));
    const Index j = std::min(static_cast<Index>(centre), pieces - 2);
    const double weight = centre - static_cast<double>(j);
    const double turn = (1 - weight) * angle[j] + weight * angle[j + 1];
    points.row(p) = is + turned(drawn_.row(p) - was, turn);
  }
  return points;
}

}  // namespace wavecurve
