#include "wavecurve/motion/morph/match_layers.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/motion/detail/oklab.hpp"
#include "wavecurve/motion/morph/detail/assignment.hpp"
#include "wavecurve/motion/morph/detail/orientation.hpp"
#include "wavecurve/motion/morph/detail/painting_order.hpp"

namespace wavecurve::motion {

namespace {

using Eigen::Index;
using Layers = std::vector<FrameLayer>;
using Partners = std::vector<std::optional<std::size_t>>;

/// The largest contour, which the others are holes or pieces of.
const Contour& largest(const std::vector<Contour>& outline) {
  return *std::max_element(outline.begin(), outline.end(), [](const Contour& a, const Contour& b) {
    return std::abs(signed_area(a)) < std::abs(signed_area(b));
  });
}

double area(const std::vector<Contour>& outline) {
  double sum = 0;
  for (const Contour& contour : outline) sum += signed_area(contour);
  return std::abs(sum);
}

std::size_t place_of(const Layers& layers, const std::string& id, const char* which) {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (layers[i].id == id) return i;
  }
  throw std::invalid_argument(
      unknown_name(fmt::format("layer of the {}", which), id, layers, &FrameLayer::id));
}

/// The partner of each layer of the source, and of the destination.
struct Matching {
  Partners of_source, of_destination;

  bool is_free(std::size_t s, std::size_t d) const { return !of_source[s] && !of_destination[d]; }
  void match(std::size_t s, std::size_t d) {
    of_source[s] = d;
    of_destination[d] = s;
  }
};

void match_by_map(const Layers& source, const Layers& destination, const LayerMap& map,
                  Matching& matching) {
  for (const auto& [from, to] : map) {
    const std::size_t s = place_of(source, from, "source");
    const std::size_t d = place_of(destination, to, "destination");
    if (!matching.is_free(s, d)) {
      throw std::invalid_argument(
          fmt::format("the map {}={} names a layer that another one has named", from, to));
    }
    matching.match(s, d);
  }
}

/// An id without the number at its end.
std::string stem(const std::string& id) {
  const std::size_t end = id.find_last_not_of("0123456789");
  return end == std::string::npos ? "" : id.substr(0, id.find_last_not_of("-_", end) + 1);
}

bool is_numbered(const std::string& id) {
  return !id.empty() && id.back() >= '0' && id.back() <= '9';
}

/// The ids, empty where they are mere numbers: they tell the place in the file, not what a layer
/// is.
std::vector<std::string> names(const Layers& layers) {
  static const std::set<std::string> elements{"path", "rect",     "circle", "ellipse",
                                              "line", "polyline", "polygon"};
  const bool all_numbered = std::all_of(layers.begin(), layers.end(), [&](const auto& layer) {
    return is_numbered(layer.id) && stem(layer.id) == stem(layers.front().id);
  });
  std::vector<std::string> result;
  for (const FrameLayer& layer : layers) {
    const bool is_number =
        all_numbered || (is_numbered(layer.id) && elements.contains(stem(layer.id)));
    result.push_back(is_number ? "" : layer.id);
  }
  return result;
}

void match_by_name(const Layers& source, const Layers& destination, Matching& matching) {
  const auto source_names = names(source), destination_names = names(destination);
  for (std::size_t s = 0; s < source.size(); ++s) {
    if (source_names[s].empty()) continue;
    for (std::size_t d = 0; d < destination.size(); ++d) {
      if (source_names[s] == destination_names[d] && matching.is_free(s, d)) matching.match(s, d);
    }
  }
}

std::vector<std::size_t> unmatched(const Partners& partners) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (!partners[i]) places.push_back(i);
  }
  return places;
}

using Lab = std::optional<Eigen::Vector3d>;

Lab lab_of(const std::optional<Colour>& colour) {
  return colour ? Lab(to_oklab(*colour)) : std::nullopt;
}

/// What a layer is matched by.
struct Look {
  explicit Look(const FrameLayer& layer)
      : centre(largest(layer.contours).colwise().mean()),
        size(std::sqrt(area(layer.contours))),
        fill(lab_of(layer.paint.fill)),
        stroke(lab_of(layer.paint.stroke)) {}
  Eigen::RowVector2d centre;
  double size;  ///< root of the area
  Lab fill, stroke;
};

std::vector<Look> looks(const Layers& layers, const std::vector<std::size_t>& places) {
  std::vector<Look> result;
  for (const std::size_t place : places) result.emplace_back(layers[place]);
  return result;
}

double colour_distance(const Lab& a, const Lab& b) {
  if (a.has_value() != b.has_value()) return 1;
  return a ? (*a - *b).norm() : 0;
}

/// Each share 0 .. about 1.
double matching_cost(const Look& a, const Look& b, double diagonal) {
  const double distance = (a.centre - b.centre).norm();
  const double size = std::abs(a.size - b.size);
  const bool has_fill = a.fill || b.fill;
  const double colour =
      has_fill ? colour_distance(a.fill, b.fill) : colour_distance(a.stroke, b.stroke);
  return (distance + size) / diagonal + colour;
}

void match_by_cost(const Layers& source, const Layers& destination, double diagonal,
                   Matching& matching) {
  const auto s = unmatched(matching.of_source), d = unmatched(matching.of_destination);
  check_assignment("layers", s.size(), d.size());
  const std::vector<Look> from = looks(source, s), to = looks(destination, d);
  Eigen::MatrixXd cost(s.size(), d.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    for (std::size_t j = 0; j < d.size(); ++j) {
      cost(static_cast<Index>(i), static_cast<Index>(j)) = matching_cost(from[i], to[j], diagonal);
    }
  }
  const auto column_of = optimal_assignment(cost);
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (column_of[i]) matching.match(s[i], d[static_cast<std::size_t>(*column_of[i])]);
  }
}

/// Whether one fill rule fills both layers as their own rules do.
bool have_common_rule(const FrameLayer& a, const FrameLayer& b) {
  if (!a.paint.fill || !b.paint.fill || a.paint.fill_rule == b.paint.fill_rule) return true;
  const FrameLayer& nonzero = a.paint.fill_rule == FillRule::nonzero ? a : b;
  return oriented(nonzero.contours, FillRule::nonzero).evenodd;
}

}  // namespace

std::vector<LayerMatch> match_layers(const Layers& source, const Layers& destination,
                                     double diagonal, const LayerMap& map) {
  Matching matching{Partners(source.size()), Partners(destination.size())};
  match_by_map(source, destination, map, matching);
  match_by_name(source, destination, matching);
  match_by_cost(source, destination, diagonal, matching);
  std::vector<LayerMatch> matches;
  for (std::size_t s = 0; s < source.size(); ++s) {
    auto& partner = matching.of_source[s];
    if (partner && !have_common_rule(source[s], destination[*partner])) {
      matching.of_destination[*partner].reset();
      partner.reset();
    }
    matches.push_back({s, partner});
  }
  for (std::size_t d = 0; d < destination.size(); ++d) {
    if (!matching.of_destination[d]) matches.push_back({std::nullopt, d});
  }
  return painting_order(matches, source, destination);
}

}  // namespace wavecurve::motion
