#include "wavecurve/motion/morph/detail/pair_contours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/motion/morph/detail/assignment.hpp"
#include "wavecurve/motion/morph/detail/nesting.hpp"

namespace wavecurve::motion {

namespace {

using Eigen::Index;
using Eigen::Vector2d;
using In = const Eigen::Ref<const Contour>&;
using Outline = std::vector<Contour>;

/// What goes with its like. The contours of a layer are oriented.
enum class Kind { outer, hole, line };

struct Piece {
  const Contour& contour;
  bool is_line;
};

std::vector<Piece> of_kind(const FrameLayer& layer, Kind kind, bool lines_are_outer) {
  std::vector<Piece> chosen;
  for (std::size_t i = 0; i < layer.contours.size(); ++i) {
    const bool is_line = is_open(layer, i);
    const Kind own = is_line ? (lines_are_outer ? Kind::outer : Kind::line)
                     : signed_area(layer.contours[i]) >= 0 ? Kind::outer
                                                           : Kind::hole;
    if (own == kind) chosen.push_back({layer.contours[i], is_line});
  }
  return chosen;
}

/// The outer contours and lines of a layer.
Outline ground(const FrameLayer& layer) {
  Outline contours;
  for (const Piece& piece : of_kind(layer, Kind::outer, true)) contours.push_back(piece.contour);
  return contours;
}

/// Where a line that runs there and back turns, the join is the cap: a miter is too long there, so
/// that it is a bevel.
bool has_joins_like_caps(const FrameLayer& layer) {
  const Paint& paint = layer.paint;
  const bool has_line = std::find(layer.open.begin(), layer.open.end(), true) != layer.open.end();
  if (!has_line || !paint.stroke) return true;
  return (paint.line_cap == LineCap::round && paint.line_join == LineJoin::round) ||
         (paint.line_cap == LineCap::butt && paint.line_join != LineJoin::round);
}

bool has_only_lines(const FrameLayer& layer) {
  for (std::size_t i = 0; i < layer.contours.size(); ++i) {
    if (!is_open(layer, i)) return false;
  }
  return true;
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

ContourPair shrink(const Piece& piece, const Outline& ground) {
  const Contour& contour = piece.contour;
  return {contour, shrinking_point(contour, ground).transpose().replicate(contour.rows(), 1),
          piece.is_line};
}

/// The better of the two starts that leave a stroke there and back: either end.
Index stroke_shift(In from, In to) {
  const Index half = from.rows() / 2;
  const Contour z = from.rowwise() - from.colwise().mean();
  const Contour w = to.rowwise() - to.colwise().mean();
  return (z - w).squaredNorm() <= (z - started_at(w, half)).squaredNorm() ? 0 : half;
}

ContourPair pair(const Piece& source, const Piece& destination, Rotation rotation,
                 std::optional<Index> start) {
  const Contour &from = source.contour, &to = destination.contour;
  const bool are_lines = source.is_line && destination.is_line;
  if (start) {
    // From within a line its way there would not be the first half.
    return {from, started_at(to, *start), are_lines && *start % (to.rows() / 2) == 0};
  }
  return {from, started_at(to, are_lines ? stroke_shift(from, to) : best_shift(from, to, rotation)),
          are_lines};
}

/// Two layers under way to their pairs.
struct Pairing {
  const FrameLayer &source, &destination;
  Outline source_ground, destination_ground;  ///< the outer contours
  Rotation rotation;
  std::optional<Index> start;
  ContourPairs pairs;

  /// Assigns the contours of a kind to each other.
  void append(Kind kind, bool lines_are_outer) {
    const std::vector<Piece> from = of_kind(source, kind, lines_are_outer);
    const std::vector<Piece> to = of_kind(destination, kind, lines_are_outer);
    check_assignment("contours", from.size(), to.size());
    Eigen::MatrixXd costs(from.size(), to.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
      for (std::size_t j = 0; j < to.size(); ++j) {
        costs(static_cast<Index>(i), static_cast<Index>(j)) = cost(from[i].contour, to[j].contour);
      }
    }
    const auto partner = optimal_assignment(costs);
    std::vector<bool> is_taken(to.size(), false);
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (!partner[i]) {
        pairs.vanishing.push_back(shrink(from[i], destination_ground));
        continue;
      }
      const auto j = static_cast<std::size_t>(*partner[i]);
      is_taken[j] = true;
      pairs.lasting.push_back(pair(from[i], to[j], rotation, start));
    }
    for (std::size_t j = 0; j < to.size(); ++j) {
      if (is_taken[j]) continue;
      const ContourPair shrinking = shrink(to[j], source_ground);
      pairs.appearing.push_back({shrinking.destination, shrinking.source, shrinking.open});
    }
  }
};

}  // namespace

ContourPairs pair_contours(const FrameLayer& source, const FrameLayer& destination,
                           Rotation rotation, std::optional<Index> start) {
  // Where both have lines alone, or the ends would look otherwise, lines keep to themselves.
  const bool lines_are_outer = has_only_lines(source) != has_only_lines(destination) &&
                               has_joins_like_caps(source) && has_joins_like_caps(destination);
  Pairing pairing{source, destination, ground(source), ground(destination), rotation, start, {}};
  pairing.append(Kind::outer, lines_are_outer);
  pairing.append(Kind::hole, lines_are_outer);
  if (!lines_are_outer) pairing.append(Kind::line, false);
  return std::move(pairing.pairs);
}

std::vector<ContourPair> shrink_contours(const FrameLayer& source, const Outline& other_ground) {
  std::vector<ContourPair> pairs;
  // One point for all, or holes would wander out of what they are holes of.
  const Outline outer = ground(source);
  const Vector2d point =
      shrinking_point(outer.empty() ? source.contours.front() : outer.front(), other_ground);
  for (std::size_t i = 0; i < source.contours.size(); ++i) {
    const Contour& contour = source.contours[i];
    pairs.push_back({contour, point.transpose().replicate(contour.rows(), 1), is_open(source, i)});
  }
  return pairs;
}

std::vector<ContourPair> reversed(std::vector<ContourPair> pairs) {
  for (ContourPair& pair : pairs) std::swap(pair.source, pair.destination);
  return pairs;
}

}  // namespace wavecurve::motion
