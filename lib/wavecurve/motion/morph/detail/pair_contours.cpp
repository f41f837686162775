#include "wavecurve/motion/morph/detail/pair_contours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
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
  Piece(std::size_t place, const Contour& points, bool is_open)
      : index(place),
        contour(points),
        is_line(is_open),
        centre(points.colwise().mean()),
        size(std::sqrt(std::abs(signed_area(points)))) {}
  std::size_t index;  ///< in the layer
  const Contour& contour;
  bool is_line;
  Eigen::RowVector2d centre;
  double size;  ///< root of the area
};

std::vector<Piece> of_kind(const FrameLayer& layer, Kind kind, bool lines_are_outer) {
  std::vector<Piece> chosen;
  for (std::size_t i = 0; i < layer.contours.size(); ++i) {
    const bool is_line = is_open(layer, i);
    const Kind own = is_line ? (lines_are_outer ? Kind::outer : Kind::line)
                     : signed_area(layer.contours[i]) >= 0 ? Kind::outer
                                                           : Kind::hole;
    if (own == kind) chosen.emplace_back(i, layer.contours[i], is_line);
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

double cost(const Piece& a, const Piece& b) {
  return (a.centre - b.centre).norm() + std::abs(a.size - b.size);
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

void check_map(const ContourMap& map, const FrameLayer& source, const FrameLayer& destination) {
  const auto last = [](const FrameLayer& layer) {
    return static_cast<long>(layer.contours.size()) - 1;
  };
  for (std::size_t k = 0; k < map.size(); ++k) {
    const auto& [from, to] = map[k];
    check_between(fmt::format("the contour of layer '{}' in a map", source.id),
                  static_cast<long>(from), 0, last(source));
    check_between(fmt::format("the contour of layer '{}' in a map", destination.id),
                  static_cast<long>(to), 0, last(destination));
    for (std::size_t i = 0; i < k; ++i) {
      if (map[i].first != from && map[i].second != to) continue;
      throw std::invalid_argument(
          fmt::format("the map {0}:{1}={2}:{3} names a contour that another one has named",
                      source.id, from, destination.id, to));
    }
  }
}

/// Two layers under way to their pairs.
struct Pairing {
  const FrameLayer &source, &destination;
  Outline source_ground, destination_ground;  ///< the outer contours
  Rotation rotation;
  std::optional<Index> start;
  const ContourMap& map;
  const HeldPair& held;
  ContourPairs pairs = {};
  std::size_t mapped = 0;  ///< of the map, so far

  /// What the map names costs less than all that it might keep apart.
  void put_map_first(Eigen::MatrixXd& costs, const std::vector<Piece>& from,
                     const std::vector<Piece>& to) {
    const double less = -1 - 2 * costs.sum();
    for (std::size_t i = 0; i < from.size(); ++i) {
      for (std::size_t j = 0; j < to.size(); ++j) {
        const auto is_named = [&](const auto& named) {
          return named.first == from[i].index && named.second == to[j].index;
        };
        if (std::none_of(map.begin(), map.end(), is_named)) continue;
        costs(static_cast<Index>(i), static_cast<Index>(j)) = less;
        ++mapped;
      }
    }
  }

  /// Assigns the contours of a kind to each other.
  void append(Kind kind, bool lines_are_outer) {
    const std::vector<Piece> from = of_kind(source, kind, lines_are_outer);
    const std::vector<Piece> to = of_kind(destination, kind, lines_are_outer);
    check_assignment("contours", from.size(), to.size());
    Eigen::MatrixXd costs(from.size(), to.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
      for (std::size_t j = 0; j < to.size(); ++j) {
        costs(static_cast<Index>(i), static_cast<Index>(j)) = cost(from[i], to[j]);
      }
    }
    put_map_first(costs, from, to);
    const auto partner = optimal_assignment(costs);
    std::vector<bool> is_taken(to.size(), false);
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (!partner[i]) {
        pairs.vanishing.push_back(shrink(from[i], destination_ground));
        continue;
      }
      const auto j = static_cast<std::size_t>(*partner[i]);
      is_taken[j] = true;
      const auto of_held = held ? held(from[i].index, to[j].index) : std::nullopt;
      pairs.lasting.push_back(of_held ? *of_held : pair(from[i], to[j], rotation, start));
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
                           Rotation rotation, std::optional<Index> start, const ContourMap& map,
                           const HeldPair& held) {
  check_map(map, source, destination);
  // Where both have lines alone, or the ends would look otherwise, lines keep to themselves.
  const bool lines_are_outer = has_only_lines(source) != has_only_lines(destination) &&
                               has_joins_like_caps(source) && has_joins_like_caps(destination);
  Pairing pairing{source, destination, ground(source), ground(destination), rotation, start,
                  map,    held};
  pairing.append(Kind::outer, lines_are_outer);
  pairing.append(Kind::hole, lines_are_outer);
  if (!lines_are_outer) pairing.append(Kind::line, false);
  if (pairing.mapped < map.size()) {
    throw std::invalid_argument(fmt::format(
        "the map of contours of layer '{}' names two of different kinds: an outer one, a hole or a line",
        source.id));
  }
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
