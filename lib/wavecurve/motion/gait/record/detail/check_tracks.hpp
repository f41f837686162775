#pragma once

#include "wavecurve/motion/gait/record/limb_tracks.hpp"

namespace wavecurve::gait {

/// Throws std::invalid_argument, naming the limb and the frame, unless the tracks are as their type
/// says: at least 4 frames at increasing times, an outline of each limb in each, all of a limb with
/// the same number of points, at least 4, everything finite, no limb twice.
void check_tracks(const LimbTracks& tracks);

}  // namespace wavecurve::gait
