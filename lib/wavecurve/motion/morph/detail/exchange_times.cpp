#include "wavecurve/motion/morph/detail/exchange_times.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "wavecurve/motion/detail/oklab.hpp"
#include "wavecurve/motion/morph/detail/covered_intervals.hpp"

namespace wavecurve::motion {

namespace {

/// Places of an order, first to last, whose layers are the same at the start.
struct Block {
  std::size_t first, last;
};

/// The smallest blocks that the order permutes, but those of one layer.
std::vector<Block> blocks_of(const std::vector<std::size_t>& order) {
  std::vector<Block> blocks;
  std::size_t first = 0, highest = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    highest = std::max(highest, order[i]);
    if (highest != i) continue;
    if (i > first) blocks.push_back({first, i});
    first = i + 1;
  }
  return blocks;
}

/// What a layer covers of a picture, and its colour.
struct Covering {
  Covering(const FrameLayer& layer, const ViewBox& box)
      : intervals(covered_intervals(layer, box, 64)) {
    const std::optional<Colour>& paint = layer.paint.fill ? layer.paint.fill : layer.paint.stroke;
    if (paint) colour = to_oklab(*paint);
  }

  CoveredIntervals intervals;
  Eigen::Vector3d colour = Eigen::Vector3d::Zero();
};

/// What is seen of the exchange of a block at a time.
double visible_change(const Animation& animation, const std::vector<std::size_t>& order,
                      const Block& block, double time) {
  std::vector<Covering> layers;
  for (std::size_t i = block.first; i <= block.last; ++i) {
    layers.emplace_back(layer_at(animation.layers[order[i]], time), animation.view_box);
  }
  double sum = 0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    for (std::size_t j = i + 1; j < layers.size(); ++j) {
      if (order[block.first + i] < order[block.first + j]) continue;
      sum += shared_length(layers[i].intervals, layers[j].intervals) *
             (layers[i].colour - layers[j].colour).norm();
    }
  }
  return sum;
}

/// In eighths of the time, from the middle.
int best_eighth(const Animation& animation, const std::vector<std::size_t>& order,
                const Block& block) {
  // More layers than this would take seconds.
  constexpr std::size_t most_compared = 1000;
  if (block.last - block.first > most_compared) return 4;
  int best = 4;
  double least = visible_change(animation, order, block, animation.duration / 2);
  for (const int eighth : {3, 5, 2, 6, 1, 7}) {
    const double change = visible_change(animation, order, block, animation.duration * eighth / 8);
    if (!(change < least)) continue;
    least = change;
    best = eighth;
  }
  return best;
}

}  // namespace

std::vector<OrderKey> exchange_times(const Animation& animation,
                                     const std::vector<std::size_t>& end) {
  std::map<int, std::vector<Block>> exchanges;
  for (const Block& block : blocks_of(end)) {
    exchanges[best_eighth(animation, end, block)].push_back(block);
  }
  std::vector<std::size_t> order(end.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<OrderKey> keys;
  for (const auto& [eighth, blocks] : exchanges) {
    for (const Block& block : blocks) {
      const auto first = static_cast<std::ptrdiff_t>(block.first);
      std::copy(end.begin() + first, end.begin() + static_cast<std::ptrdiff_t>(block.last) + 1,
                order.begin() + first);
    }
    keys.push_back({animation.duration * eighth / 8, order});
  }
  return keys;
}

}  // namespace wavecurve::motion
