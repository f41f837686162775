#pragma once

#include <array>
#include <vector>

#include "wavecurve/motion/gait/model/fit_models.hpp"
#include "wavecurve/motion/gait/record/gait_cycle.hpp"

namespace wavecurve::gait {

struct Subcycles {
  std::vector<LimbPath> paths;      ///< LF, LH
  std::vector<PhaseGammas> gammas;  ///< of LF, A to D, then of LH
  std::vector<PhaseData> data;      ///< in the same order
};

/// The publication's cycle, of the left limbs, from two key frames at which all limbs are known:
///   A from key frame 1 to 2, B from 2 to 1', C from 1' to 2', D from 2' to 1,
/// where 1' and 2' are 1 and 2 with left and right exchanged, half a cycle later. A left limb so
/// passes through its own key frames, then through those of the right one. Offset: of key frame 1
/// after LF's touch-down, as a share of the cycle.
///
/// The gammas are fitted to all that the record shows of a subcycle, of left limbs, and of right
/// ones half a cycle later, each between its own key frames. Where one of a pair is missing, the
/// other's record half a cycle later stands for it. Publication, section 4.2, Figures 9 and 10.
///
/// Tracks of control points, and the cycle with feet numbered as control points are; times of the
/// key frames within the record. Throws std::invalid_argument unless key frame 2 is after 1, by
/// less than half a period, and for a subcycle of which the record shows nothing.
Subcycles fit_subcycles(const LimbTracks& control_points, const GaitCycle& cycle,
                        const std::array<double, 2>& key_frames, const ModelSetting& setting);

/// LF's first lift-off, and a quarter of the period later: when the foot is amid its swing, "lifts
/// off and thrusts forward".
std::array<double, 2> automatic_key_frames(const GaitCycle& cycle);

}  // namespace wavecurve::gait
