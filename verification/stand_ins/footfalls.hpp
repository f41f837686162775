#pragma once

#include <array>

#include "wavecurve/motion/gait/model/limb_path.hpp"
#include "wavecurve/motion/gait/walk/ground_contact.hpp"

#include "verification/stand_ins/example_gait.hpp"

namespace wavecurve::verification {

/// The stances of LF, RF, LH, RH, their begins counted from that of LF as shares of the cycle.
using Footfalls = std::array<gait::CyclePart, 4>;

/// In a record: the means over its cycles, of the times in which a foot moves backwards at more
/// than half of the ground's speed, as ground_contact has it. Speeds are those between neighbouring
/// frames; where they pass that bound is found by linear interpolation.
Footfalls recorded_footfalls(const gait::LimbTracks& tracks, const gait::GaitCycle& cycle);

/// The footfalls of a model.
Footfalls model_footfalls(const std::vector<gait::LimbPath>& paths, double facing);

}  // namespace wavecurve::verification
