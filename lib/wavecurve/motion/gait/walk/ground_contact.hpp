#pragma once

#include "wavecurve/motion/gait/model/limb_path.hpp"

namespace wavecurve::gait {

/// A part of the cycle, from begin on, 0 <= begin < 1, 0 < length < 1.
struct CyclePart {
  double begin = 0, length = 0;

  /// How far a share of the cycle is into the part, or past it: 0 <= result < 1.
  double since(double u) const;
};

/// When a foot stands: the longest part of the cycle in which it moves backwards at more than 0.6
/// of its mean speed from the foremost to the rearmost place. (At these it rests relative to the
/// body, and so does not yet, or no more, stand on the ground, which never rests.) Throws
/// std::invalid_argument naming the limb if its foot does not move.
CyclePart ground_contact(const LimbPath& path, double facing);

}  // namespace wavecurve::gait
