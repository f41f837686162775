#include "wavecurve/motion/gait/walk/gait_animation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/motion/gait/model/detail/control_points.hpp"
#include "wavecurve/motion/gait/walk/detail/walking_limb.hpp"
#include "wavecurve/motion/gait/walk/synthesize_gait.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::RowVector2d;

struct SampledLayer {
  std::string id;
  Paint paint;
  std::vector<Contour> contours;
  std::optional<std::size_t> limb;  ///< of limb_names
};

std::vector<SampledLayer> sampled(const Drawing& drawing, Index samples) {
  std::vector<SampledLayer> layers;
  for (const Layer& layer : drawing.layers) {
    const auto name = std::find(limb_names.begin(), limb_names.end(), layer.id);
    layers.push_back({layer.id, layer.paint, sample_layer(layer, samples), {}});
    if (name != limb_names.end()) {
      layers.back().limb = static_cast<std::size_t>(name - limb_names.begin());
    }
  }
  return layers;
}

/// The outlines of the four limbs.
std::array<Contour, 4> drawn_limbs(const std::vector<SampledLayer>& layers) {
  std::array<Contour, 4> limbs;
  for (const SampledLayer& layer : layers) {
    if (layer.limb) limbs[*layer.limb] = layer.contours.front();
  }
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    if (limbs[i].rows() > 0) continue;
    throw std::invalid_argument(fmt::format(
        "the drawing has no layer '{}', but the gait moves LF, RF, LH and RH", limb_names[i]));
  }
  return limbs;
}

/// Fore limbs are on the side to which the animal looks.
double facing_of(const std::array<Contour, 4>& limbs) {
  const auto x = [&](std::size_t i) { return limbs[i].col(0).mean(); };
  return x(0) + x(1) > x(2) + x(3) ? 1 : -1;
}

/// How the body goes with the hinges of its limbs.
struct BodyShift {
  double hind_x = 0, fore_x = 0;
  RowVector2d hind, fore;

  /// Beyond the hinges, half the trunk's length at most takes part in a pitch.
  RowVector2d at(double x) const {
    const double share = std::clamp((x - hind_x) / (fore_x - hind_x), -0.5, 1.5);
    return (1 - share) * hind + share * fore;
  }
};

void check(const GaitAnimationOptions& options) {
  check_at_least("frames", options.frames, 2);
  check_at_least("cycles", options.cycles, 1);
  check_above_zero("the duration of a cycle", options.cycle_duration);
}

std::vector<WalkingLimb> walking_limbs(const GaitParameters& parameters,
                                       const std::array<Contour, 4>& drawn,
                                       const GaitAnimationOptions& options) {
  const double facing = facing_of(drawn);
  const auto paths =
      options.subcycles ? subcycle_paths(parameters) : gait_paths(parameters, options.gait);
  const ControlPoints points(options.bank, parameters.samples, parameters.scale);
  std::vector<WalkingLimb> limbs;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    limbs.emplace_back(
        RecordedLimb{paths[i], points, facing != parameters.facing, options.continuity}, drawn[i],
        facing);
  }
  double stride = 0;
  for (const WalkingLimb& limb : limbs) stride += limb.own_stride() / 4;
  for (WalkingLimb& limb : limbs) limb.hold_to_ground(stride);
  return limbs;
}

/// The contours of a layer with so few control points.
void coarsen(std::vector<Contour>& contours, const std::optional<ControlPoints>& coarse) {
  if (!coarse) return;
  for (Contour& contour : contours) contour = coarse->draw(coarse->analyse(contour));
}

/// What the feet do in the frames of a cycle.
void measure(const std::vector<WalkingLimb>& limbs,
             const std::vector<std::array<Contour, 4>>& frames, const std::vector<double>& shares,
             GaitAnimation& result) {
  for (std::size_t l = 0; l < limbs.size(); ++l) {
    const WalkingLimb& limb = limbs[l];
    double slide = 0, lift = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const double since = limb.contact().since(shares[i]);
      if (since > limb.contact().length) continue;
      const Contour& outline = frames[i][l];
      slide = std::max(slide, std::abs(outline(limb.rig().foot(), 0) - limb.ground_x(since)));
      lift = std::max(lift, std::abs(outline.col(1).maxCoeff() - limb.ground_y()));
    }
    result.slide = std::max(result.slide, slide / result.stride);
    result.lift = std::max(result.lift, lift / result.stride);
    result.slide_before = std::max(result.slide_before, limb.slide_before() / result.stride);
  }
}

}  // namespace

GaitAnimation animate_gait(const GaitParameters& parameters, const Drawing& drawing,
                           const GaitAnimationOptions& options) {
  check(options);
  const std::vector<SampledLayer> layers = sampled(drawing, options.samples);
  const auto limbs = walking_limbs(parameters, drawn_limbs(layers), options);
  std::optional<ControlPoints> coarse;
  if (options.scale) coarse.emplace(options.bank, options.samples, *options.scale);

  GaitAnimation result;
  result.stride = limbs.front().stride();
  motion::Animation& animation = result.animation;
  animation.view_box = drawing.view_box;
  animation.duration = options.cycles * options.cycle_duration;
  for (const SampledLayer& layer : layers) {
    animation.layers.push_back({layer.id, {}, {{0, layer.paint}}});
  }
  std::vector<std::array<Contour, 4>> outlines;
  std::vector<double> shares;
  const double hind_x = (limbs[2].rig().hinge_x() + limbs[3].rig().hinge_x()) / 2;
  const double fore_x = (limbs[0].rig().hinge_x() + limbs[1].rig().hinge_x()) / 2;
  for (int i = 0; i <= options.frames; ++i) {
    // The last frame is the first, to the last bit.
    const double turns =
        i < options.frames ? static_cast<double>(i) * options.cycles / options.frames : 0;
    const double u = turns - std::floor(turns);
    std::array<WalkingLimb::State, 4> states;
    for (std::size_t l = 0; l < 4; ++l) states[l] = limbs[l].at(u);
    const BodyShift body{hind_x, fore_x, (states[2].hinge_shift + states[3].hinge_shift) / 2,
                         (states[0].hinge_shift + states[1].hinge_shift) / 2};
    std::array<Contour, 4> feet;
    for (std::size_t k = 0; k < layers.size(); ++k) {
      std::vector<Contour> contours = layers[k].contours;
      if (layers[k].limb) {
        const std::size_t l = *layers[k].limb;
        contours.assign(1, states[l].outline);
        coarsen(contours, coarse);
        feet[l] = contours.front();
      } else {
        for (Contour& contour : contours) {
          for (Index p = 0; p < contour.rows(); ++p) contour.row(p) += body.at(contour(p, 0));
        }
        coarsen(contours, coarse);
      }
      animation.layers[k].outline.push_back(
          {animation.duration * i / options.frames, std::move(contours)});
    }
    outlines.push_back(std::move(feet));
    shares.push_back(u);
  }
  measure(limbs, outlines, shares, result);
  return result;
}

}  // namespace wavecurve::gait
