#include "wavecurve/motion/morph/detail/held_corners.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/curves/detail/anchored_path.hpp"
#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::motion {

namespace {

using Eigen::Index;

/// Places of vertices in their order around two contours, by increasing place in the first.
using Anchors = std::vector<std::pair<std::size_t, std::size_t>>;

std::size_t place_of_vertex(const AnchoredPath& path, std::size_t number) {
  const auto& vertices = path.vertices();
  const auto found = std::ranges::find(vertices, number, &PathVertex::number);
  if (found == vertices.end()) {
    throw std::invalid_argument(fmt::format(
        "the anchor at vertex {} is none: no segment of that contour starts there", number));
  }
  return static_cast<std::size_t>(found - vertices.begin());
}

/// Longest part of the anchors, from one on and around, that follow each other around the second
/// contour, too.
Anchors following(const Anchors& anchors, std::size_t first, std::size_t vertices) {
  const std::size_t count = anchors.size();
  const auto place = [&](std::size_t k) {
    return (anchors[(first + k) % count].second + vertices - anchors[first].second) % vertices;
  };
  std::vector<std::size_t> length(count, 0), before(count, 0);
  length[0] = 1;
  std::size_t last = 0;
  for (std::size_t k = 1; k < count; ++k) {
    for (std::size_t i = 0; i < k; ++i) {
      if (length[i] == 0 || place(i) >= place(k) || length[i] < length[k]) continue;
      length[k] = length[i] + 1;
      before[k] = i;
    }
    if (length[k] > length[last]) last = k;
  }
  Anchors chosen;
  for (std::size_t k = last; k > 0; k = before[k]) chosen.push_back(anchors[(first + k) % count]);
  chosen.push_back(anchors[first]);
  std::ranges::reverse(chosen);
  return chosen;
}

/// The longest part from any on; of many, only the first few are tried, for each takes the square.
Anchors longest_following(const Anchors& anchors, std::size_t vertices) {
  constexpr std::size_t most_tried = 16, most_anchors = 1000;
  if (anchors.size() > most_anchors) return {};
  Anchors longest;
  for (std::size_t first = 0; first < std::min(anchors.size(), most_tried); ++first) {
    Anchors chosen = following(anchors, first, vertices);
    if (chosen.size() > longest.size()) longest = std::move(chosen);
  }
  return longest;
}

Anchors shared_corners(const AnchoredPath& from, const AnchoredPath& to, double distance) {
  Anchors anchors;
  for (std::size_t i = 0; i < from.vertices().size(); ++i) {
    if (!from.vertices()[i].is_corner) continue;
    for (std::size_t j = 0; j < to.vertices().size(); ++j) {
      if (!to.vertices()[j].is_corner) continue;
      if ((from.vertices()[i].point - to.vertices()[j].point).norm() > distance) continue;
      anchors.emplace_back(i, j);
      break;
    }
  }
  return longest_following(anchors, to.vertices().size());
}

Anchors anchors_of(const VertexPairs& vertices, const AnchoredPath& from, const AnchoredPath& to) {
  Anchors anchors;
  for (const auto& [i, j] : vertices) {
    anchors.emplace_back(place_of_vertex(from, i), place_of_vertex(to, j));
  }
  std::ranges::sort(anchors);
  const bool is_one_twice =
      std::ranges::adjacent_find(anchors, {}, &Anchors::value_type::first) != anchors.end();
  if (is_one_twice || longest_following(anchors, to.vertices().size()).size() < anchors.size()) {
    throw std::invalid_argument(
        "the anchors do not follow each other around both contours in the same direction");
  }
  return anchors;
}

/// The numbers of a contour's vertices, from one to before the other.
struct VertexRange {
  std::size_t first, end;
};

VertexRange vertices_of(const Layer& layer, std::size_t contour) {
  VertexRange range{0, 0};
  for (std::size_t i = 0; i <= contour; ++i) {
    const Subpath& subpath = layer.subpaths[i];
    range = {range.end, range.end + subpath.segments.size() + (subpath.closed ? 0 : 1)};
  }
  return range;
}

/// The anchors of two contours, counted within these.
VertexPairs between(const VertexPairs& anchors, VertexRange from, VertexRange to) {
  VertexPairs vertices;
  for (const auto& [i, j] : anchors) {
    if (i < from.first || i >= from.end || j < to.first || j >= to.end) continue;
    vertices.emplace_back(i - from.first, j - to.first);
  }
  return vertices;
}

/// How many of all points lie between anchors.
std::vector<Index> counts_between(const std::vector<double>& from, double from_length,
                                  const std::vector<double>& to, double to_length, Index points) {
  std::vector<double> shares;
  for (std::size_t k = 0; k < from.size(); ++k) {
    shares.push_back(from[k] / from_length + to[k] / to_length);
  }
  return shares_of_samples(shares, points);
}

}  // namespace

std::optional<ContourPair> held_pair(const SampledPath& source, const SampledPath& destination,
                                     const VertexPairs& vertices, double distance) {
  const AnchoredPath from(source.path, source.points), to(destination.path, destination.points);
  const Anchors anchors =
      vertices.empty() ? shared_corners(from, to, distance) : anchors_of(vertices, from, to);
  const Index points = source.points.rows();
  if (anchors.empty() || static_cast<Index>(anchors.size()) > points) return std::nullopt;
  std::vector<std::size_t> on_source, on_destination;
  for (const auto& [i, j] : anchors) {
    on_source.push_back(i);
    on_destination.push_back(j);
  }
  const std::vector<Index> counts =
      counts_between(from.lengths_between(on_source), from.length(),
                     to.lengths_between(on_destination), to.length(), points);
  return ContourPair{from.points(on_source, counts), to.points(on_destination, counts)};
}

HeldVertices::HeldVertices(const Layer& source, const Layer& destination, VertexPairs anchors,
                           double distance)
    : source_(source),
      destination_(destination),
      anchors_(std::move(anchors)),
      distance_(distance) {}

std::optional<ContourPair> HeldVertices::pair(const FrameLayer& from, const FrameLayer& to,
                                              std::size_t i, std::size_t j) {
  if (i >= source_.subpaths.size() || j >= destination_.subpaths.size()) return std::nullopt;
  const VertexPairs vertices =
      between(anchors_, vertices_of(source_, i), vertices_of(destination_, j));
  found_ += vertices.size();
  const bool is_line = is_open(from, i) || is_open(to, j);
  const bool is_stroked = from.paint.stroke || to.paint.stroke;
  if (vertices.empty() && (is_line || is_stroked || !anchors_.empty())) return std::nullopt;
  return held_pair({source_.subpaths[i], from.contours[i]},
                   {destination_.subpaths[j], to.contours[j]}, vertices, distance_);
}

void HeldVertices::check_found() const {
  if (found_ >= anchors_.size()) return;
  throw std::invalid_argument(fmt::format(
      "an anchor of layer '{}' has vertices that are on no two matched contours", source_.id));
}

}  // namespace wavecurve::motion
