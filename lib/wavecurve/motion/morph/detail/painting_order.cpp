#include "wavecurve/motion/morph/detail/painting_order.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include <Eigen/Geometry>

#include "wavecurve/curves/crossings.hpp"
#include "wavecurve/motion/morph/detail/covered_intervals.hpp"
#include "wavecurve/motion/morph/detail/nesting.hpp"

namespace wavecurve::motion {

namespace {

using Box = Eigen::AlignedBox2d;
using LayerIndex = std::optional<std::size_t>;

std::vector<Box> boxes_of(const std::vector<FrameLayer>& layers) {
  std::vector<Box> boxes(layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const double margin = layers[i].paint.stroke ? layers[i].paint.stroke_width / 2 : 0;
    for (const Contour& contour : layers[i].contours) {
      boxes[i].extend(Eigen::Vector2d(contour.colwise().minCoeff().array() - margin));
      boxes[i].extend(Eigen::Vector2d(contour.colwise().maxCoeff().array() + margin));
    }
  }
  return boxes;
}

/// Whether it makes no difference which of two layers is painted first.
bool look_alike(const Paint& a, const Paint& b) {
  return !a.stroke && !b.stroke && a.fill && a.fill == b.fill && a.fill_opacity == 1 &&
         b.fill_opacity == 1;
}

/// Whether layers really overlap: their areas do, or, which small pieces need, outlines cross or one holds a point of
/// the other. Strokes reach beyond their outlines, so their boxes decide.
bool overlap(const FrameLayer& a, const FrameLayer& b) {
  if (look_alike(a.paint, b.paint)) return false;
  if (a.paint.stroke || b.paint.stroke || share_area(a, b)) return true;
  for (const Contour& p : a.contours) {
    for (const Contour& q : b.contours) {
      if (winding_number(p, q.row(0)) != 0 || winding_number(q, p.row(0)) != 0 ||
          count_crossings(p, q) > 0) {
        return true;
      }
    }
  }
  return false;
}

using Demands = Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// Which match, the row, is to be painted before which other at one of the ends.
Demands demands(const std::vector<LayerIndex>& layers, const std::vector<Box>& boxes) {
  const auto count = static_cast<Eigen::Index>(layers.size());
  Demands result(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const LayerIndex a = layers[static_cast<std::size_t>(i)],
                       b = layers[static_cast<std::size_t>(j)];
      result(i, j) = a && b && *a < *b && boxes[*a].intersects(boxes[*b]);
    }
  }
  return result;
}

/// What both ends demand, where they contradict each other only if layers really overlap there.
struct BothEnds {
  BothEnds(const std::vector<LayerMatch>& matches, const std::vector<FrameLayer>& source,
           const std::vector<FrameLayer>& destination) {
    std::vector<LayerIndex> from, to;
    for (const LayerMatch& match : matches) {
      from.push_back(match.source);
      to.push_back(match.destination);
    }
    at_start = demands(from, boxes_of(source));
    at_end = demands(to, boxes_of(destination));
    const auto count = static_cast<Eigen::Index>(matches.size());
    contradictions = Demands::Constant(count, count, false);
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j < count; ++j) {
        if (!at_start(i, j) || !at_end(j, i)) continue;
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        at_start(i, j) = overlap(source[*from[a]], source[*from[b]]);
        at_end(j, i) = overlap(destination[*to[a]], destination[*to[b]]);
        contradictions(i, j) = at_start(i, j) && at_end(j, i);
      }
    }
  }

  Demands at_start, at_end;
  Demands contradictions;  ///< demands of the start, against which the end has one
};

/// An order of the indices that meets all demands of the first kind, which go in no circle, and
/// what it can of the second; else the order given.
std::vector<std::size_t> ordered(const Demands& first, const Demands& second) {
  const auto count = first.rows();
  std::vector<Eigen::Index> left(static_cast<std::size_t>(count));
  std::iota(left.begin(), left.end(), 0);
  const auto waiting = [](const Demands& demands) {
    return Eigen::VectorX<Eigen::Index>(demands.cast<Eigen::Index>().colwise().sum().transpose());
  };
  // How many of those left come before each.
  Eigen::VectorX<Eigen::Index> must_wait = waiting(first), may_wait = waiting(second);
  std::vector<std::size_t> result;
  while (!left.empty()) {
    auto next = left.end();
    for (auto candidate = left.begin(); candidate != left.end(); ++candidate) {
      if (must_wait[*candidate] != 0) continue;
      if (next == left.end() || may_wait[*candidate] < may_wait[*next]) next = candidate;
      if (may_wait[*next] == 0) break;
    }
    result.push_back(static_cast<std::size_t>(*next));
    must_wait -= first.row(*next).cast<Eigen::Index>().transpose();
    may_wait -= second.row(*next).cast<Eigen::Index>().transpose();
    left.erase(next);
  }
  return result;
}

/// The demands without some.
Demands without(const Demands& demands, const Demands& some) {
  return demands.binaryExpr(some, [](bool a, bool b) { return a && !b; });
}

}  // namespace

std::vector<LayerMatch> painting_order(const std::vector<LayerMatch>& matches,
                                       const std::vector<FrameLayer>& source,
                                       const std::vector<FrameLayer>& destination) {
  const BothEnds ends(matches, source, destination);
  std::vector<LayerMatch> result;
  for (const std::size_t i :
       ordered(ends.at_start, without(ends.at_end, ends.contradictions.transpose()))) {
    result.push_back(matches[i]);
  }
  return result;
}

std::vector<std::size_t> final_painting_order(const std::vector<LayerMatch>& matches,
                                              const std::vector<FrameLayer>& source,
                                              const std::vector<FrameLayer>& destination) {
  const BothEnds ends(matches, source, destination);
  return ordered(ends.at_end, without(ends.at_start, ends.contradictions));
}

}  // namespace wavecurve::motion
