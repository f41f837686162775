#pragma once

#include <string>

#include "wavecurve/motion/gait/model/gait_parameters.hpp"

namespace wavecurve::tools {

/// When feet stand, as bars, and the models that were chosen.
std::string gait_summary(const gait::GaitParameters& parameters);

/// The same with the ways of the feet, the residuals of every model, and gammas of whole limbs.
std::string gait_table(const gait::GaitParameters& parameters);

}  // namespace wavecurve::tools
