#include "wavecurve/motion/morph/detail/pair_contours.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/motion/morph/detail/assignment.hpp"
#include "wavecurve/motion/morph/detail/holes.hpp"
#include "wavecurve/motion/morph/detail/nesting.hpp"

namespace wavecurve::motion {

namespace {

using Eigen::Index;
using Eigen::Vector2d;
using In = const Eigen::Ref<const Contour>&;
using Outline = std::vector<Contour>;

/// The contours of an oriented outline that turn one way: outer ones, or holes.
Outline turning(const Outline& outline, bool clockwise) {
  Outline chosen;
  for (const Contour& contour : outline) {
    if ((signed_area(contour) >= 0) == clockwise) chosen.push_back(contour);
  }
  return chosen;
}

double root_of_area(In contour) { return std::sqrt(std::abs(signed_area(contour))); }

double cost(In a, In b) {
  return (a.colwise().mean() - b.colwise().mean()).norm() +
         std::abs(root_of_area(a) - root_of_area(b));
}

/// Where a contour shrinks to: a point inside of it if that is inside a contour of the ground, else
/// a point inside the nearest of those; its own if there is no ground.
Vector2d shrinking_point(In contour, const Outline& ground) {
  const Vector2d own = interior_point(contour);
  const Contour* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Contour& parent : ground) {
    if (winding_number(parent, own) != 0) return own;
    const double distance = (parent.rowwise() - own.transpose()).rowwise().squaredNorm().minCoeff();
    if (distance < least) {
      least = distance;
      nearest = &parent;
    }
  }
  return nearest == nullptr ? own : interior_point(*nearest);
}

ContourPair shrink(In contour, const Outline& ground) {
  return {contour, shrinking_point(contour, ground).transpose().replicate(contour.rows(), 1)};
}

/// The better of the two starts that leave a stroke there and back: either end.
Index stroke_shift(In from, In to) {
  const Index half = from.rows() / 2;
  const Contour z = from.rowwise() - from.colwise().mean();
  const Contour w = to.rowwise() - to.colwise().mean();
  return (z - w).squaredNorm() <= (z - started_at(w, half)).squaredNorm() ? 0 : half;
}

ContourPair pair(In from, In to, Rotation rotation, std::optional<Index> start) {
  if (start) return {from, started_at(to, *start)};
  const bool are_strokes = is_there_and_back(from) && is_there_and_back(to);
  return {from,
          started_at(to, are_strokes ? stroke_shift(from, to) : best_shift(from, to, rotation))};
}

/// Assigns contours of the same kind to each other; `ground` holds the outer contours of both.
void append_pairs(const Outline& source, const Outline& destination, const Outline& source_ground,
                  const Outline& destination_ground, Rotation rotation, std::optional<Index> start,
                  std::vector<ContourPair>& pairs) {
  check_assignment("contours", source.size(), destination.size());
  Eigen::MatrixXd costs(source.size(), destination.size());
  for (std::size_t i = 0; i < source.size(); ++i) {
    for (std::size_t j = 0; j < destination.size(); ++j) {
      costs(static_cast<Index>(i), static_cast<Index>(j)) = cost(source[i], destination[j]);
    }
  }
  const auto partner = optimal_assignment(costs);
  std::vector<bool> is_taken(destination.size(), false);
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (!partner[i]) {
      pairs.push_back(shrink(source[i], destination_ground));
      continue;
    }
    const auto j = static_cast<std::size_t>(*partner[i]);
    is_taken[j] = true;
    pairs.push_back(pair(source[i], destination[j], rotation, start));
  }
  for (std::size_t j = 0; j < destination.size(); ++j) {
    if (is_taken[j]) continue;
    const ContourPair shrinking = shrink(destination[j], source_ground);
    pairs.push_back({shrinking.destination, shrinking.source});
  }
}

}  // namespace

std::vector<Contour> oriented(std::vector<Contour> outline, std::optional<FillRule> rule) {
  const std::vector<bool> hole =
      rule ? holes(outline, *rule) : std::vector<bool>(outline.size(), false);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if ((signed_area(outline[i]) >= 0) != hole[i]) continue;
    // The first point stays the first.
    const Index others = outline[i].rows() - 1;
    outline[i].bottomRows(others) = outline[i].bottomRows(others).colwise().reverse().eval();
  }
  return outline;
}

bool is_there_and_back(In contour) {
  const Index count = contour.rows();
  const double extent = (contour.colwise().maxCoeff() - contour.colwise().minCoeff()).maxCoeff();
  // Samples of both ways are equal but for the rounding of arc lengths.
  const double tolerance = 1e-9 * extent;
  for (Index i = 1; 2 * i < count; ++i) {
    if (!((contour.row(i) - contour.row(count - i)).cwiseAbs().maxCoeff() <= tolerance)) {
      return false;
    }
  }
  return count > 2;
}

std::vector<ContourPair> pair_contours(const Outline& source, const Outline& destination,
                                       Rotation rotation, std::optional<Index> start) {
  const Outline source_ground = turning(source, true);
  const Outline destination_ground = turning(destination, true);
  std::vector<ContourPair> pairs;
  append_pairs(source_ground, destination_ground, source_ground, destination_ground, rotation,
               start, pairs);
  append_pairs(turning(source, false), turning(destination, false), source_ground,
               destination_ground, rotation, start, pairs);
  return pairs;
}

std::vector<ContourPair> shrink_contours(const Outline& source, const Outline& ground) {
  std::vector<ContourPair> pairs;
  // One point for all, or holes would wander out of what they are holes of.
  const Outline outer = turning(source, true);
  const Vector2d point = shrinking_point(outer.empty() ? source.front() : outer.front(), ground);
  for (const Contour& contour : source) {
    pairs.push_back({contour, point.transpose().replicate(contour.rows(), 1)});
  }
  return pairs;
}

std::vector<ContourPair> reversed(std::vector<ContourPair> pairs) {
  for (ContourPair& pair : pairs) std::swap(pair.source, pair.destination);
  return pairs;
}

}  // namespace wavecurve::motion
