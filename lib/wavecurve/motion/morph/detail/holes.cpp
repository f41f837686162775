#include "wavecurve/motion/morph/detail/holes.hpp"

#include <algorithm>
#include <cstddef>
#include <set>

#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/motion/morph/detail/nesting.hpp"

namespace wavecurve::motion {

namespace {

using Eigen::Index;

/// A piece of a contour along which y grows, or falls, strictly. It is met by the horizontal lines at
/// top <= y < bottom.
struct Chain {
  std::vector<Eigen::Vector2d> points;  ///< by increasing y
  std::size_t contour;
  int turn;  ///< what it takes from the winding number, passed from left to right

  double top() const { return points.front().y(); }
  double bottom() const { return points.back().y(); }
  /// How much to the right it goes downward at its top.
  double lean() const { return (points[1].x() - points[0].x()) / (points[1].y() - points[0].y()); }

  double x(double y) const {
    const auto above = [](double value, const Eigen::Vector2d& point) { return value < point.y(); };
    const auto end = std::upper_bound(points.begin() + 1, points.end() - 1, y, above);
    const Eigen::Vector2d &a = *(end - 1), &b = *end;
    return a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
  }
};

/// Compares chains that one horizontal line meets, in the middle of the lines that do.
struct IsLeftOf {
  bool operator()(const Chain* a, const Chain* b) const {
    const double y = (std::max(a->top(), b->top()) + std::min(a->bottom(), b->bottom())) / 2;
    return a->x(y) < b->x(y);
  }
};

void append_chains(const Contour& contour, std::size_t number, std::vector<Chain>& chains) {
  const Index count = contour.rows();
  const auto point = [&](Index i) { return Eigen::Vector2d(contour.row(i % count)); };
  // Begins where a chain does, so that none is cut in two.
  Index first = 0;
  contour.col(1).minCoeff(&first);
  int direction = 0;
  for (Index i = first; i < first + count; ++i) {
    const Eigen::Vector2d a = point(i), b = point(i + 1);
    const int now = (a.y() < b.y()) - (a.y() > b.y());
    if (now != 0) {
      if (now != direction) chains.push_back({{a}, number, -now});
      chains.back().points.push_back(b);
    }
    direction = now;
  }
}

std::vector<Chain> chains_of(const std::vector<Contour>& outline) {
  std::vector<Chain> chains;
  for (std::size_t i = 0; i < outline.size(); ++i) append_chains(outline[i], i, chains);
  for (Chain& chain : chains) {
    if (chain.turn > 0) std::reverse(chain.points.begin(), chain.points.end());
  }
  return chains;
}

/// The winding number outside of each contour, of the other ones. A line sweeps downward; the chains
/// that it meets stand in order, each with the winding number on its right side, which stays the same
/// as long as nothing crosses.
std::vector<int> outer_windings(const std::vector<Contour>& outline) {
  const std::vector<Chain> chains = chains_of(outline);
  std::vector<const Chain*> starting, ending;
  for (const Chain& chain : chains) starting.push_back(&chain);
  ending = starting;
  std::sort(starting.begin(), starting.end(), [](const Chain* a, const Chain* b) {
    if (a->top() != b->top()) return a->top() < b->top();
    if (a->points[0].x() != b->points[0].x()) return a->points[0].x() < b->points[0].x();
    return a->lean() < b->lean();
  });
  std::sort(ending.begin(), ending.end(),
            [](const Chain* a, const Chain* b) { return a->bottom() < b->bottom(); });

  using Met = std::multiset<const Chain*, IsLeftOf>;
  Met met;
  std::vector<Met::iterator> place(chains.size());
  std::vector<int> right_of(chains.size()), outside(outline.size());
  std::vector<bool> is_known(outline.size(), false);
  const auto number = [&](const Chain* chain) {
    return static_cast<std::size_t>(chain - chains.data());
  };
  auto next_end = ending.begin();
  for (const Chain* chain : starting) {
    for (; (*next_end)->bottom() <= chain->top(); ++next_end) met.erase(place[number(*next_end)]);
    const auto here = place[number(chain)] = met.insert(chain);
    const int left = here == met.begin() ? 0 : right_of[number(*std::prev(here))];
    right_of[number(chain)] = left + chain->turn;
    if (is_known[chain->contour]) continue;
    is_known[chain->contour] = true;
    outside[chain->contour] = left;
  }
  return outside;
}

}  // namespace

std::vector<bool> holes(const std::vector<Contour>& outline, FillRule rule, double most_plain) {
  double edges = 0;
  for (const Contour& contour : outline) edges += static_cast<double>(contour.rows());
  std::vector<bool> result(outline.size());
  if (edges * static_cast<double>(outline.size()) <= most_plain) {
    for (std::size_t i = 0; i < outline.size(); ++i) result[i] = is_hole(outline, i, rule);
    return result;
  }
  const std::vector<int> outside = outer_windings(outline);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    result[i] = !is_filled(outside[i] + (signed_area(outline[i]) >= 0 ? 1 : -1), rule);
  }
  return result;
}

}  // namespace wavecurve::motion
