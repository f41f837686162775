#include "wavecurve/motion/morph/detail/exchange_times.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "wavecurve/motion/detail/oklab.hpp"

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

using Interval = std::pair<double, double>;

/// What a layer covers along each of some horizontal lines, and its colour.
class Picture {
 public:
  Picture(const FrameLayer& layer, const ViewBox& box) : lines_(count) {
    const Paint& paint = layer.paint;
    const std::optional<Colour>& colour = paint.fill ? paint.fill : paint.stroke;
    if (colour) colour_ = to_oklab(*colour);
    const double margin = paint.stroke ? paint.stroke_width / 2 : 0;
    std::vector<std::vector<double>> meetings(count);
    for (const Contour& contour : layer.contours) add(contour, box, meetings);
    for (std::size_t line = 0; line < count; ++line) {
      std::vector<double>& x = meetings[line];
      std::sort(x.begin(), x.end());
      // Inside of a fill by the even-odd rule; a stroke has its width about each meeting.
      const std::size_t step = paint.fill ? 2 : 1;
      for (std::size_t i = 0; i + step <= x.size(); i += step) {
        add_interval(lines_[line], {x[i] - margin, x[i + step - 1] + margin});
      }
    }
  }

  /// The length that both cover, times the distance of their colours.
  double shared(const Picture& other) const {
    double length = 0;
    for (std::size_t line = 0; line < count; ++line) {
      auto a = lines_[line].begin();
      auto b = other.lines_[line].begin();
      while (a != lines_[line].end() && b != other.lines_[line].end()) {
        length += std::max(0.0, std::min(a->second, b->second) - std::max(a->first, b->first));
        if (a->second < b->second) {
          ++a;
        } else {
          ++b;
        }
      }
    }
    return length * (colour_ - other.colour_).norm();
  }

 private:
  static constexpr std::size_t count = 64;

  static void add_interval(std::vector<Interval>& intervals, const Interval& interval) {
    if (intervals.empty() || intervals.back().second < interval.first) {
      intervals.push_back(interval);
    } else {
      intervals.back().second = std::max(intervals.back().second, interval.second);
    }
  }

  /// Where the lines, at the middles of equal shares of the box, meet a contour.
  static void add(const Contour& contour, const ViewBox& box,
                  std::vector<std::vector<double>>& meetings) {
    const double height = box.height / count;
    const auto line_after = [&](double y) {
      const double line = std::ceil((y - box.y) / height - 0.5);
      return static_cast<std::size_t>(std::clamp(line, 0.0, static_cast<double>(count)));
    };
    for (Eigen::Index i = 0; i < contour.rows(); ++i) {
      Eigen::RowVector2d a = contour.row(i), b = contour.row((i + 1) % contour.rows());
      if (a.y() > b.y()) std::swap(a, b);
      for (std::size_t line = line_after(a.y()); line < line_after(b.y()); ++line) {
        const double y = box.y + (static_cast<double>(line) + 0.5) * height;
        meetings[line].push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
      }
    }
  }

  std::vector<std::vector<Interval>> lines_;
  Eigen::Vector3d colour_ = Eigen::Vector3d::Zero();
};

/// What is seen of the exchange of a block at a time.
double visible_change(const Animation& animation, const std::vector<std::size_t>& order,
                      const Block& block, double time) {
  std::vector<Picture> pictures;
  for (std::size_t i = block.first; i <= block.last; ++i) {
    pictures.emplace_back(layer_at(animation.layers[order[i]], time), animation.view_box);
  }
  double sum = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    for (std::size_t j = i + 1; j < pictures.size(); ++j) {
      if (order[block.first + i] > order[block.first + j]) sum += pictures[i].shared(pictures[j]);
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
