#include "wavecurve/motion/gait/record/canine_joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::RowVector2d;

constexpr double degree = std::numbers::pi / 180;

RowVector2d along(double angle) { return {cosine(angle), sine(angle)}; }

/// From 0 to 1, with neither speed nor acceleration at the ends.
double smooth_step(double s) { return s * s * s * (10 + s * (-15 + 6 * s)); }

/// From 0 to 1 in the middle and back, without speed at the ends.
double hump(double s) { return 16 * s * s * (1 - s) * (1 - s); }

/// The same, but largest before the middle.
double early_hump(double s) { return 1.7 * hump(s) * (1 - s); }

/// Angles are counted from x to y: 0 points forwards, 90 degrees down.
struct Foot {
  RowVector2d toe;
  double digits = 0;      ///< angle of the digits
  double metacarpus = 0;  ///< angle of the metacarpus
};

Foot foot_at(const CanineBuild& build, const CanineLimb& limb, double duty_factor, double stride,
             double phase) {
  // The metacarpus slopes backwards up to the carpus at touch-down, and forwards at lift-off.
  constexpr double landing = 60 * degree, leaving = 100 * degree;
  constexpr double hanging = 40 * degree, hanging_digits = 80 * degree;
  const double sweep = stride * duty_factor;
  const double front = limb.pivot.x() + build.reach + sweep / 2;
  Foot foot;
  if (phase < duty_factor) {
    foot.toe << front - stride * phase, build.ground;
    foot.metacarpus = landing + (leaving - landing) * smooth_step(phase / duty_factor);
    return foot;
  }
  const double s = (phase - duty_factor) / (1 - duty_factor);
  const double carried = stride * (1 - duty_factor);  // by the ground, in the time of the swing
  foot.toe << front - sweep - carried * s + (sweep + carried) * smooth_step(s),
      build.ground - build.clearance * hump(s);
  foot.metacarpus = leaving + (landing - leaving) * smooth_step(s) + hanging * early_hump(s);
  foot.digits = hanging_digits * early_hump(s);
  return foot;
}

/// Pivot, two joints and the end of three segments, the third parallel to the first: as if the
/// first were as long as both, and the second came after it. The first joint is in front.
Contour pantograph(const CanineLimb& limb, const RowVector2d& end) {
  const auto [first, second, third] = limb.segments;
  const RowVector2d way = end - limb.pivot;
  const double distance = way.norm(), outer = first + third;
  if (!(distance <= outer + second) || !(distance >= std::abs(outer - second))) {
    throw std::domain_error(
        must_be("the distance of a foot from the pivot of its limb", distance,
                fmt::format("from {} to {}", std::abs(outer - second), outer + second)));
  }
  const double cosine =
      (distance * distance + outer * outer - second * second) / (2 * distance * outer);
  const double angle = arctangent(way.y(), way.x()) - arccosine(std::min(cosine, 1.0));
  Contour joints(4, 2);
  joints.row(0) = limb.pivot;
  joints.row(1) = limb.pivot + first * along(angle);
  joints.row(2) = end - third * along(angle);
  joints.row(3) = end;
  return joints;
}

Contour chain(const CanineLimb& limb, const Foot& foot) {
  const RowVector2d knuckle = foot.toe - limb.digits * along(foot.digits);
  const bool fore = limb.metacarpus > 0;
  const RowVector2d end =
      fore ? RowVector2d(knuckle - limb.metacarpus * along(foot.metacarpus)) : knuckle;
  Contour joints(fore ? 6 : 5, 2);
  joints.topRows(4) = pantograph(limb, end);
  if (fore) joints.row(4) = knuckle;
  joints.bottomRows(1) = foot.toe;
  return joints;
}

}  // namespace

CanineBuild drawn_dog() {
  CanineBuild dog;
  dog.fore = {{228, 112}, {37, 37.5, 37.5}, 16, 12};
  dog.hind = {{112, 112}, {43, 43, 40}, 0, 14};
  dog.ground = 224;
  dog.reach = 8;
  dog.sweep = 84;
  dog.clearance = 14;
  return dog;
}

double stride_length(const CanineBuild& build, const CanineGait& gait) {
  double duty_factor = 0;
  for (const LimbTiming& limb : gait.limbs) duty_factor = std::max(duty_factor, limb.duty_factor);
  return build.sweep / duty_factor;
}

LimbTracks canine_joints(const CanineBuild& build, const CanineGait& gait,
                         const Eigen::Ref<const Eigen::VectorXd>& phases) {
  const double stride = stride_length(build, gait);
  LimbTracks tracks{phases, {}};
  for (std::size_t i = 0; i < limb_names.size(); ++i) {
    const CanineLimb& limb = limb_names[i][1] == 'F' ? build.fore : build.hind;
    LimbTrack track{std::string(limb_names[i]), {}};
    for (const double phase : phases) {
      const double since = phase - gait.limbs[i].touch_down;
      const Foot foot =
          foot_at(build, limb, gait.limbs[i].duty_factor, stride, since - std::floor(since));
      track.outlines.push_back(chain(limb, foot));
    }
    tracks.limbs.push_back(std::move(track));
  }
  return tracks;
}

}  // namespace wavecurve::gait
