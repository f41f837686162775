#include "wavecurve/io/animations/detail/painting_slots.hpp"

#include <algorithm>
#include <optional>

namespace wavecurve::io {

namespace {

using Order = std::vector<std::size_t>;
using Slots = std::vector<PaintingSlot>;

/// The slots that an order finds on its way up, or nothing where a layer has none above the last.
std::optional<std::vector<std::size_t>> found_slots(const Slots& slots, const Order& order) {
  std::vector<std::size_t> found;
  std::size_t slot = 0;
  for (const std::size_t layer : order) {
    while (slot < slots.size() && slots[slot].layer != layer) ++slot;
    if (slot == slots.size()) return std::nullopt;
    found.push_back(slot++);
  }
  return found;
}

/// Marks a longest increasing subsequence (by patience sorting).
std::vector<bool> longest_increasing(const std::vector<std::size_t>& values) {
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> tails, before(values.size(), none);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto at =
        std::lower_bound(tails.begin(), tails.end(), values[i],
                         [&](std::size_t tail, std::size_t value) { return values[tail] < value; });
    if (at != tails.begin()) before[i] = *(at - 1);
    if (at == tails.end()) {
      tails.push_back(i);
    } else {
      *at = i;
    }
  }
  std::vector<bool> chosen(values.size(), false);
  for (std::size_t i = tails.empty() ? none : tails.back(); i != none; i = before[i]) {
    chosen[i] = true;
  }
  return chosen;
}

/// By layer: the slot where it was shown last before order k, or its first.
std::vector<std::size_t> last_slots(const Slots& slots, std::size_t k) {
  std::vector<std::size_t> last(slots.size());
  std::vector<std::size_t> orders(slots.size(), 0);  // one more than the order, none of them yet
  for (std::size_t i = slots.size(); i-- > 0;) {
    const PaintingSlot& slot = slots[i];
    std::size_t order = k;
    while (order > 0 && !slot.is_shown[order - 1]) --order;
    if (order < orders[slot.layer]) continue;
    orders[slot.layer] = order;
    last[slot.layer] = i;
  }
  return last;
}

/// The slots with new ones for the layers that do not stay where they were shown last.
Slots with_order(const Slots& slots, const Order& order, std::size_t k) {
  const std::vector<std::size_t> last = last_slots(slots, k);
  std::vector<std::size_t> places;
  for (const std::size_t layer : order) places.push_back(last[layer]);
  const std::vector<bool> stays = longest_increasing(places);
  Slots result;
  auto next = slots.begin();
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (stays[i]) {
      const auto end = slots.begin() + static_cast<std::ptrdiff_t>(places[i]) + 1;
      result.insert(result.end(), next, end);
      next = end;
    } else {
      result.push_back({order[i], std::vector<bool>(slots.front().is_shown.size(), false)});
    }
    result.back().is_shown[k] = true;
  }
  result.insert(result.end(), next, slots.end());
  return result;
}

}  // namespace

bool PaintingSlot::is_always_shown() const {
  return std::all_of(is_shown.begin(), is_shown.end(), [](bool shown) { return shown; });
}

Slots painting_slots(const motion::Animation& animation) {
  const std::size_t orders = animation.order.size() + 1;
  Slots slots;
  for (std::size_t i = 0; i < animation.layers.size(); ++i) {
    slots.push_back({i, std::vector<bool>(orders, false)});
    slots.back().is_shown[0] = true;
  }
  for (std::size_t k = 1; k < orders; ++k) {
    const Order& order = animation.order[k - 1].order;
    const auto found = found_slots(slots, order);
    if (!found) {
      slots = with_order(slots, order, k);
      continue;
    }
    for (const std::size_t slot : *found) slots[slot].is_shown[k] = true;
  }
  if (orders == 1 || animation.order.front().time > 0) return slots;
  for (PaintingSlot& slot : slots) slot.is_shown[0] = slot.is_shown[1];
  return slots;
}

}  // namespace wavecurve::io
