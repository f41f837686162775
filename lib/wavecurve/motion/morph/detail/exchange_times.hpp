#pragma once

#include <cstddef>
#include <vector>

#include "wavecurve/motion/animation.hpp"

namespace wavecurve::motion {

/// When the layers of an animation, painted as they stand at its start, come into the order of its
/// end. Layers that change places with each other do so at once, at that eighth of the time where it
/// shows least: where the areas that they have in common, times the distances of their colours in
/// OKLab, sum up to the least. No keys if the order is theirs already.
std::vector<OrderKey> exchange_times(const Animation& animation,
                                     const std::vector<std::size_t>& end);

}  // namespace wavecurve::motion
