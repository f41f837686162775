#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/motion/morph/morph.hpp"

namespace wavecurve::motion {

/// The proper crossings of a layer's contours at each of the normalised times tau: of each with
/// itself, and of holes with holes and with outer contours. Outer contours that pass over each other
/// do not count, for what they cover together has no seam. An open line counts once, by itself, and
/// a contour that is a point but for rounding not at all.
std::vector<Eigen::Index> crossings(const Morph& morph, const MorphLayer& layer,
                                    const std::vector<double>& taus);

/// What was chosen for a layer: its scale, which of the alternatives its correspondence is from,
/// and how many crossings are left at all times together.
struct ScaleChoice {
  std::string layer;
  Eigen::Index scale = 0;
  std::size_t alternative = 0;
  Eigen::Index crossings = 0;
};

struct ChosenMorph {
  Morph morph;
  std::vector<ScaleChoice> choices;  ///< one a layer
};

/// For each layer the finest scale, from its own on, that has no crossing at the times, of the
/// first of the alternatives where one has none; failing that, its own scale with the alternative of
/// the fewest crossings, so never more than the first one has as it is. The alternatives are morphs of the same layers in the
/// same order with different correspondences.
///
/// With Detail::stage, details fade in frames that move already; where crossings are left, the
/// share of the time that they take is halved, up to five times. With Detail::blend all scales give
/// the same frames, so only the correspondence is chosen.
/// `progress` is called with the layers done and those there are.
/// Throws std::invalid_argument unless there is an alternative, and as animate does.
ChosenMorph avoid_crossings(const std::vector<Morph>& alternatives, const std::vector<double>& taus,
                            const std::function<void(std::size_t, std::size_t)>& progress = {});

}  // namespace wavecurve::motion
