#pragma once

#include <string>

#include "wavecurve/motion/gait/gait_parameters.hpp"

namespace wavecurve::tools {

/// When feet stand, as bars; residuals of every model, limb and phase; gammas of whole limbs.
std::string gait_table(const GaitParameters& parameters);

}  // namespace wavecurve::tools
