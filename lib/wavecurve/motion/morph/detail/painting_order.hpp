#pragma once

#include <vector>

#include "wavecurve/motion/morph/match_layers.hpp"

namespace wavecurve::motion {

/// The matches in an order that paints both ends right: of two layers whose bounding boxes
/// overlap in the source, or in the destination, the lower one comes first. Where the two
/// contradict each other, the source has its way, unless the outlines overlap only in the
/// destination. Otherwise the order is kept.
std::vector<LayerMatch> painting_order(const std::vector<LayerMatch>& matches,
                                       const std::vector<FrameLayer>& source,
                                       const std::vector<FrameLayer>& destination);

}  // namespace wavecurve::motion
