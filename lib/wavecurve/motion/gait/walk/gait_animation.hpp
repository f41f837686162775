#pragma once

#include <optional>

#include <Eigen/Core>

#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/motion/animation.hpp"
#include "wavecurve/motion/gait/model/gait_parameters.hpp"
#include "wavecurve/motion/gait/record/canine_gaits.hpp"

namespace wavecurve::gait {

struct GaitAnimationOptions {
  FilterBank<double> bank;           ///< of the parameters
  std::optional<CanineGait> gait{};  ///< its offsets and duty factors; none: the recorded ones
  bool subcycles = false;            ///< the publication's, from two key frames
  Continuity continuity = Continuity::position;
  int frames = 60;  ///< of all cycles; the one after the last is the first
  int cycles = 1;
  double cycle_duration = 1;            ///< seconds
  Eigen::Index samples = 256;           ///< points a contour, a power of two
  std::optional<Eigen::Index> scale{};  ///< control points of every contour; none: all points
};

/// A drawing that walks in place, as on a treadmill, and what is known about its feet.
struct GaitAnimation {
  motion::Animation animation;  ///< frames + 1 keys, the last is the first: it loops
  double stride = 0;            ///< by which the ground moves in a cycle, in units of the drawing
  /// The farthest that a standing foot gets from its place on the ground, and that the lowest point
  /// of a standing limb gets from its height, as shares of the stride: in the frames that are
  /// there, and as it was before feet were held to the ground.
  double slide = 0, slide_before = 0, lift = 0;
};

/// The layers LF, RF, LH, RH of a drawing moved by a fitted gait, each in its pose
/// as drawn when the recorded foot is where the drawn one is; the other layers go with the body,
/// whose ends move as the limbs' hinges do, fore and hind, on average.
///
/// While a foot stands (ground_contact.hpp), it is held to the ground: the limb is bent by what its
/// foot differs from a point that moves backwards evenly, by the same stride for all limbs, and its
/// lowest point from the height at which it is drawn. In the swing, what it is bent by changes
/// smoothly from the one stance to the next, and the limb does not reach below the ground.
///
/// A drawing that looks to the other side than the recorded animal (fore limbs left or right of the
/// hind ones) gets the mirrored motion. Throws std::invalid_argument for a drawing without one of
/// the four layers, frames < 2, cycles < 1, and as ControlPoints and sample_layer do.
GaitAnimation animate_gait(const GaitParameters& parameters, const Drawing& drawing,
                           const GaitAnimationOptions& options);

}  // namespace wavecurve::gait
