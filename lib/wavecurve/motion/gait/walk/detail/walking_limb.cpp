#include "wavecurve/motion/gait/walk/detail/walking_limb.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::RowVector2d;

constexpr int probes = 32;  ///< places in a stance, or in the cycle, that means are taken over

/// The pose of the stance in which the recorded limb leans as the drawn one does.
Contour reference_pose(const RecordedLimb& recorded, const CyclePart& contact,
                       const Contour& drawn) {
  const LimbRig rough(recorded.outline(contact.begin + contact.length / 2), recorded.foot(), drawn);
  Contour best;
  double least = 0;
  for (int i = 0; i <= probes; ++i) {
    const Contour pose = recorded.outline(contact.begin + contact.length * i / probes);
    const double difference = std::abs(rough.recorded_lean(pose) - rough.drawn_lean());
    if (i > 0 && difference >= least) continue;
    least = difference;
    best = pose;
  }
  return best;
}

CyclePart contact_of(const RecordedLimb& recorded, double facing) {
  return ground_contact(recorded.path, recorded.mirrored ? -facing : facing);
}

}  // namespace

Contour RecordedLimb::outline(double u) const {
  const Contour points_now = points.draw(pose_at(path, u, continuity));
  if (!mirrored) return points_now;
  Contour other(points_now.rows(), 2);
  for (Index i = 0; i < other.rows(); ++i) {
    const Index from = (other.rows() - i) % other.rows();
    other.row(i) << -points_now(from, 0), points_now(from, 1);
  }
  return other;
}

Index RecordedLimb::foot() const {
  const Index foot = path.foot * points.samples() / points.scale();
  return mirrored ? (points.samples() - foot) % points.samples() : foot;
}

WalkingLimb::WalkingLimb(RecordedLimb recorded, const Contour& drawn, double facing)
    : recorded_(std::move(recorded)),
      facing_(facing),
      contact_(contact_of(recorded_, facing)),
      rig_(reference_pose(recorded_, contact_, drawn), recorded_.foot(), drawn),
      ground_y_(drawn.col(1).maxCoeff()) {
  for (int i = 0; i < probes; ++i) {
    mean_hinge_shift_ +=
        rig_.hinge_shift(recorded_.outline(i / static_cast<double>(probes))) / probes;
  }
  // The line through the foot's places in the stance, by least squares.
  double sum = 0, moment = 0, second = 0;
  for (int i = 0; i <= probes; ++i) {
    const double since = contact_.length * i / probes;
    const double x = free(contact_.begin + since).outline(rig_.foot(), 0);
    const double t = since - contact_.length / 2;
    sum += x;
    moment += t * x;
    second += t * t;
  }
  middle_x_ = sum / (probes + 1);
  own_stride_ = -facing_ * moment / second;
}

double WalkingLimb::ground_x(double since) const {
  return middle_x_ - facing_ * stride_ * (since - contact_.length / 2);
}

WalkingLimb::State WalkingLimb::free(double u) const {
  const Contour recorded = recorded_.outline(u);
  State state{rig_.pose(recorded), rig_.hinge_shift(recorded) - mean_hinge_shift_};
  state.outline.rowwise() += state.hinge_shift;
  return state;
}

RowVector2d WalkingLimb::lacking(const Contour& outline, double since) const {
  RowVector2d reach(ground_x(since) - outline(rig_.foot(), 0), 0);
  // The lowest point is not quite the foot, and another one when the limb is bent.
  for (int pass = 0; pass < 3; ++pass) {
    const Eigen::VectorXd heights = outline.col(1) + reach.y() * rig_.shares();
    Index lowest = 0;
    const double height = heights.maxCoeff(&lowest);
    reach.y() += (ground_y_ - height) / std::max(rig_.shares()[lowest], 0.5);
  }
  return reach;
}

void WalkingLimb::hold_to_ground(double stride) {
  stride_ = stride;
  constexpr double step = 1.0 / 512;
  const auto at = [&](double since) {
    return lacking(free(contact_.begin + since).outline, since);
  };
  down_ = at(0);
  down_slope_ = (at(step) - down_) / step;
  off_ = at(contact_.length);
  off_slope_ = (off_ - at(contact_.length - step)) / step;
  for (int i = 0; i <= probes; ++i) {
    const double since = contact_.length * i / probes;
    const double x = free(contact_.begin + since).outline(rig_.foot(), 0);
    slide_before_ = std::max(slide_before_, std::abs(x - ground_x(since)));
  }
  is_held_ = true;
}

RowVector2d WalkingLimb::reach(const Contour& outline, double u) const {
  const double since = contact_.since(u);
  if (since <= contact_.length) return lacking(outline, since);
  const double swing = 1 - contact_.length, t = (since - contact_.length) / swing;
  const double s = 1 - t;
  RowVector2d reach = s * s * (1 + 2 * t) * off_ + t * t * (1 + 2 * s) * down_ +
                      swing * s * t * (s * off_slope_ - t * down_slope_);
  const double below = (outline.col(1) + reach.y() * rig_.shares()).maxCoeff() - ground_y_;
  if (below > 0) reach.y() -= below;
  return reach;
}

WalkingLimb::State WalkingLimb::at(double u) const {
  State state = free(u);
  if (is_held_) state.outline += rig_.shares() * reach(state.outline, u);
  return state;
}

}  // namespace wavecurve::gait
