#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/motion/animation.hpp"
#include "wavecurve/motion/gait/model/gait_parameters.hpp"
#include "wavecurve/motion/gait/record/canine_gaits.hpp"

namespace wavecurve::gait {

/// The four limbs' paths of a whole cycle: those that were recorded, a missing limb from the one of
/// the other side, half a cycle later. With another gait, if given, each foot is on the ground
/// (ground_contact.hpp) when that gait has it there.
/// Throws std::invalid_argument where both limbs of a pair are missing.
std::vector<LimbPath> gait_paths(const GaitParameters& parameters,
                                 const std::optional<CanineGait>& gait = std::nullopt);

/// The publication's cycle: subcycles A to D from two key frames, right limbs the left ones half a
/// cycle on (section 4.2, Figures 9 and 12).
std::vector<LimbPath> subcycle_paths(const GaitParameters& parameters);

}  // namespace wavecurve::gait
