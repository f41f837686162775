#pragma once

#include <cstddef>
#include <vector>

#include "wavecurve/motion/morph/match_layers.hpp"

namespace wavecurve::motion {

/// The matches in an order that paints the source right, and if it can the destination: of two
/// layers whose bounding boxes overlap in the source, the lower one comes first, and so do those of
/// the destination where these demands leave it open. Otherwise the order is kept.
///
/// Where source and destination contradict each other, only layers whose outlines overlap demand
/// anything, and of these only those that do not look alike.
std::vector<LayerMatch> painting_order(const std::vector<LayerMatch>& matches,
                                       const std::vector<FrameLayer>& source,
                                       const std::vector<FrameLayer>& destination);

/// The order of the matches, given in painting_order, that paints the destination right, as near to
/// theirs as it can be: their indices.
std::vector<std::size_t> final_painting_order(const std::vector<LayerMatch>& matches,
                                              const std::vector<FrameLayer>& source,
                                              const std::vector<FrameLayer>& destination);

}  // namespace wavecurve::motion
