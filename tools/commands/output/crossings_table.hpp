#pragma once

#include <string>
#include <vector>

#include "wavecurve/motion/morph/avoid_crossings.hpp"
#include "wavecurve/motion/morph/morph.hpp"

namespace wavecurve::tools {

/// One line a layer: its scale, the crossings of all frames together, and which frames (counted
/// from 1) have how many. The first and the last frame are the drawings themselves and not counted;
/// taus are the normalised times of those in between.
std::string crossings_table(const motion::Morph& morph, const std::vector<double>& taus);

/// What was chosen for each layer.
std::string choices_table(const motion::ChosenMorph& chosen);

}  // namespace wavecurve::tools
