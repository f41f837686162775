#include "wavecurve/motion/gait/walk/detail/limb_rig.hpp"

#include <algorithm>
#include <cmath>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/sample_contour.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::RowVector2d;

constexpr double most_hinge_shift = 0.08;  ///< of the limb's length: a trunk does not stretch
constexpr Index around = 3;  ///< pieces of the midline on either side that turn with one

/// The length of the open polygon.
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

/// By the angle whose cosine and sine are given.
RowVector2d turned(const RowVector2d& v, const RowVector2d& turn) {
  return {turn.x() * v.x() - turn.y() * v.y(), turn.y() * v.x() + turn.x() * v.y()};
}

}  // namespace

LimbRig::LimbRig(const Contour& reference, Index foot, const Contour& drawn)
    : recorded_midline_(reference, foot),
      reference_nodes_(recorded_midline_.nodes(reference)),
      reference_hinge_(reference_nodes_.row(0)),
      drawn_(drawn),
      drawn_midline_(drawn, drawn_foot(reference, foot, drawn)),
      drawn_nodes_(drawn_midline_.nodes(drawn)),
      scale_(perimeter(drawn) / perimeter(reference)) {
  const Index pieces = drawn_nodes_.rows() - 1;
  for (Index p = 0; p < drawn_.rows(); ++p) {
    Hold hold;
    const double place = drawn_midline_.shares()[p] * static_cast<double>(pieces);
    hold.piece = std::min(static_cast<Index>(place), pieces - 1);
    hold.share = place - static_cast<double>(hold.piece);
    // Between the middles of pieces turns are linear, so that the outline has no kinks.
    const double centre = std::clamp(place - 0.5, 0.0, static_cast<double>(pieces - 1));
    hold.turn = std::min(static_cast<Index>(centre), pieces - 2);
    hold.turn_share = centre - static_cast<double>(hold.turn);
    hold.offset = drawn_.row(p) - (1 - hold.share) * drawn_nodes_.row(hold.piece) -
                  hold.share * drawn_nodes_.row(hold.piece + 1);
    holds_.push_back(hold);
  }
}

RowVector2d LimbRig::hinge_shift(const Contour& recorded) const {
  const RowVector2d shift = scale_ * (recorded_midline_.nodes(recorded).row(0) - reference_hinge_);
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
  Contour turns(pieces, 2), nodes(now.rows(), 2);  // cosines and sines; of the drawn limb
  nodes.row(0) = drawn_nodes_.row(0);
  for (Index i = 0; i < pieces; ++i) {
    // Over more than a piece, since an outline's pieces turn more roughly than the limb.
    const Index first = std::max<Index>(i - around, 0), last = std::min(i + 1 + around, pieces);
    const RowVector2d before = reference_nodes_.row(last) - reference_nodes_.row(first);
    const RowVector2d after = now.row(last) - now.row(first);
    turns.row(i) << before.dot(after), before.x() * after.y() - before.y() * after.x();
    turns.row(i).normalize();
    nodes.row(i + 1) =
        nodes.row(i) + turned(drawn_nodes_.row(i + 1) - drawn_nodes_.row(i), turns.row(i));
  }
  Contour points(drawn_.rows(), 2);
  for (Index p = 0; p < points.rows(); ++p) {
    const Hold& hold = holds_[static_cast<std::size_t>(p)];
    const RowVector2d on_midline =
        (1 - hold.share) * nodes.row(hold.piece) + hold.share * nodes.row(hold.piece + 1);
    const RowVector2d turn =
        (1 - hold.turn_share) * turns.row(hold.turn) + hold.turn_share * turns.row(hold.turn + 1);
    points.row(p) = on_midline + turned(hold.offset, turn.normalized());
  }
  return points;
}

}  // namespace wavecurve::gait
