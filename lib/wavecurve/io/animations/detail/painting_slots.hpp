#pragma once

#include <cstddef>
#include <vector>

#include "wavecurve/motion/animation.hpp"

namespace wavecurve::io {

/// A place in the stack of a player that paints in one order for all time: a layer, and in which of
/// the orders it is shown there; order 0 is that before the first key, order k that from key k - 1 on. Where
/// the first key is at time 0, order 0 is as order 1.
struct PaintingSlot {
  std::size_t layer = 0;
  std::vector<bool> is_shown;

  bool is_always_shown() const;
};

/// The slots, the lowest first, such that those shown are in the animation's painting order at every
/// time, each layer of it once. As few layers as possible change their slot from one order to the next.
std::vector<PaintingSlot> painting_slots(const motion::Animation& animation);

}  // namespace wavecurve::io
