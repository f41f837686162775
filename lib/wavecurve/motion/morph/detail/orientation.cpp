#include "wavecurve/motion/morph/detail/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "wavecurve/curves/crossings.hpp"
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

void reverse(Contour& contour) {
  const Index others = contour.rows() - 1;  // the first point stays the first
  contour.bottomRows(others) = contour.bottomRows(others).colwise().reverse().eval();
}

int turn_of(const Contour& contour) { return signed_area(contour) >= 0 ? 1 : -1; }

/// Contours that do not cross themselves nor each other. With w the winding number of the outline as
/// it is, that of the result is |w| under the nonzero rule, and w modulo 2 under the other.
Orientation of_disjoint(std::vector<Contour> outline, const std::vector<int>& outside,
                        FillRule rule) {
  Orientation result{std::move(outline), true, true};
  for (std::size_t i = 0; i < outside.size(); ++i) {
    Contour& contour = result.contours[i];
    const int outer = std::abs(outside[i]), inner = std::abs(outside[i] + turn_of(contour));
    const bool clockwise = rule == FillRule::nonzero ? inner > outer : outer % 2 == 0;
    if ((turn_of(contour) > 0) != clockwise) reverse(contour);
    if (rule == FillRule::nonzero && std::max(inner, outer) > 1) result.evenodd = false;
  }
  return result;
}

/// The middles of a number of edges, at equal distances along the contour.
std::vector<Eigen::Vector2d> middles(const Contour& contour, Index number) {
  std::vector<Eigen::Vector2d> points;
  for (Index i = 0; i < number; ++i) {
    const Index at = (2 * i + 1) * contour.rows() / (2 * number);
    points.emplace_back((contour.row(at) + contour.row((at + 1) % contour.rows())) / 2);
  }
  return points;
}

/// Whether a contour lies on both sides of another one, though they may cross in vertices only, which
/// are no proper crossings.
bool lies_on_both_sides(const Contour& contour, const Contour& other) {
  const std::vector<Eigen::Vector2d> points = middles(contour, std::min<Index>(16, contour.rows()));
  const int first = winding_number(other, points.front());
  return std::any_of(points.begin(), points.end(), [&](const Eigen::Vector2d& point) {
    return winding_number(other, point) != first;
  });
}

bool cross(const Contour& a, const Contour& b) {
  return count_crossings(a, b) > 0 || lies_on_both_sides(a, b) || lies_on_both_sides(b, a);
}

/// Contours that cross each other, directly or by others, are one cluster.
class Clusters {
 public:
  explicit Clusters(const std::vector<Contour>& outline) : outline_(outline) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      of_.push_back(i);
      boxes_.emplace_back(outline[i].colwise().minCoeff(), outline[i].colwise().maxCoeff());
      if (count_crossings(outline[i]) > 0) are_disjoint_ = false;
      for (std::size_t j = 0; j < i; ++j) {
        if (of_[i] != of_[j] && boxes_[i].intersects(boxes_[j]) && cross(outline[i], outline[j])) {
          join(of_[i], of_[j]);
        }
      }
    }
  }

  bool are_disjoint() const { return are_disjoint_; }

  /// The winding number, of all contours of other clusters, round those of this one's. They touch it
  /// at most, so the commonest number in the middles of a few edges is meant; each contour counts
  /// with a factor.
  int outside(std::size_t i, const std::vector<int>& factor) const {
    std::map<int, int> votes;
    for (const Eigen::Vector2d& middle : middles(outline_[i], 5)) {
      ++votes[winding(i, middle, factor)];
    }
    const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
    return std::max_element(votes.begin(), votes.end(), fewer)->first;
  }

  /// The members of each cluster, those of larger extent first.
  std::vector<std::vector<std::size_t>> members() const {
    std::map<std::size_t, std::vector<std::size_t>> found;
    for (std::size_t i = 0; i < of_.size(); ++i) found[of_[i]].push_back(i);
    std::vector<std::vector<std::size_t>> result;
    for (auto& [cluster, contours] : found) result.push_back(std::move(contours));
    const auto extent = [&](const std::vector<std::size_t>& contours) {
      Eigen::AlignedBox2d box;
      for (const std::size_t i : contours) box.extend(boxes_[i]);
      return box.volume();
    };
    std::stable_sort(result.begin(), result.end(),
                     [&](const auto& a, const auto& b) { return extent(a) > extent(b); });
    return result;
  }

 private:
  void join(std::size_t a, std::size_t b) {
    std::replace(of_.begin(), of_.end(), a, b);
    are_disjoint_ = false;
  }

  int winding(std::size_t i, const Eigen::Vector2d& point, const std::vector<int>& factor) const {
    int sum = 0;
    for (std::size_t j = 0; j < outline_.size(); ++j) {
      if (of_[j] == of_[i] || factor[j] == 0 || !boxes_[j].contains(point)) continue;
      sum += factor[j] * winding_number(outline_[j], point);
    }
    return sum;
  }

  const std::vector<Contour>& outline_;
  std::vector<Eigen::AlignedBox2d> boxes_;
  std::vector<std::size_t> of_;
  bool are_disjoint_ = true;
};

/// Contours of which some cross, under the nonzero rule: a cluster keeps its winding numbers, or all
/// of it is reversed. Where it lies in what is filled it turns as that does; else its largest contour
/// turns clockwise.
Orientation of_crossing(std::vector<Contour> outline, const Clusters& clusters) {
  const std::vector<int> plain(outline.size(), 1);
  std::vector<int> factor(outline.size(), 0);  // 0: not decided, and not round what is
  for (const std::vector<std::size_t>& members : clusters.members()) {
    const int outside = clusters.outside(members.front(), plain);
    const auto smaller = [&](std::size_t a, std::size_t b) {
      return std::abs(signed_area(outline[a])) < std::abs(signed_area(outline[b]));
    };
    const std::size_t largest = *std::max_element(members.begin(), members.end(), smaller);
    int sign = turn_of(outline[largest]);
    if (outside != 0) {
      sign = outside * clusters.outside(members.front(), factor) < 0 ? -1 : 1;
    }
    for (const std::size_t i : members) factor[i] = sign;
  }
  Orientation result{std::move(outline), true, false};
  for (std::size_t i = 0; i < factor.size(); ++i) {
    if (factor[i] < 0) reverse(result.contours[i]);
  }
  return result;
}

/// Whether the pairs of contours whose boxes meet have few points together; each pair counts as a
/// hundred more.
bool is_within(const std::vector<Contour>& outline, double most_points) {
  constexpr std::size_t most_contours = 3000;  // whose boxes are compared at once
  if (outline.size() > most_contours) return false;
  std::vector<Eigen::AlignedBox2d> boxes;
  double points = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    boxes.emplace_back(outline[i].colwise().minCoeff(), outline[i].colwise().maxCoeff());
    for (std::size_t j = 0; j < i; ++j) {
      if (!boxes[i].intersects(boxes[j])) continue;
      points += static_cast<double>(outline[i].rows() + outline[j].rows() + 100);
      if (points > most_points) return false;
    }
  }
  return true;
}

}  // namespace

Orientation oriented(std::vector<Contour> outline, std::optional<FillRule> rule,
                     double most_plain) {
  if (!rule) {
    for (Contour& contour : outline) {
      if (turn_of(contour) < 0) reverse(contour);
    }
    return {std::move(outline), true, true};
  }
  if (!is_within(outline, most_plain)) {
    const std::vector<int> outside = outer_windings(outline);
    return of_disjoint(std::move(outline), outside, *rule);
  }
  const Clusters clusters(outline);
  if (!clusters.are_disjoint()) {
    if (*rule == FillRule::nonzero) return of_crossing(outline, clusters);
    return {std::move(outline), false, true};
  }
  std::vector<int> outside;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    outside.push_back(clusters.outside(i, std::vector<int>(outline.size(), 1)));
  }
  return of_disjoint(std::move(outline), outside, *rule);
}

}  // namespace wavecurve::motion
