#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/motion/morph/match_layers.hpp"
#include "wavecurve/motion/morph/morph.hpp"

namespace wavecurve::motion {

/// A contour of a layer of the source and one of its partner, counted from 0 in the order of the file.
struct MappedContours {
  std::string source_layer;
  std::size_t source = 0;
  std::string destination_layer;
  std::size_t destination = 0;
};

/// Vertices, where segments meet, of a layer of the source and of its partner, counted from 0 through all
/// contours in the order of the file; an open contour has one more than segments.
struct Anchor {
  std::string layer;
  std::size_t source = 0, destination = 0;
};

struct MorphOptions {
  FilterBank<double> bank;
  Eigen::Index samples = 1024;          ///< points a contour, a power of two
  std::optional<Eigen::Index> scale{};  ///< control points that are interpolated; none: all
  Detail detail = Detail::blend;
  double stage_share = 0.25;  ///< of the duration, see Morph
  double duration = 2;        ///< seconds
  Rotation rotation = Rotation::kept;
  LayerMap map{};
  /// By id of the source's layer: the point of the destination's contours that is their first,
  /// instead of the one that correspondence finds.
  std::vector<std::pair<std::string, Eigen::Index>> starts{};
  /// Contours of two layers that are matched with each other.
  std::vector<MappedContours> contours{};
  /// Vertices that correspond. Without any in a layer, the corners that both drawings share do.
  std::vector<Anchor> anchors{};
  /// Ignored: shared corners are nothing special, and all samples uniform, as the publication's.
  Corners shared_corners = Corners::kept;
};

/// The morph of one drawing into another. The view box is the source's; the destination is scaled
/// uniformly to fit it, as a player fits it to the screen. Layers are matched by match_layers and
/// their contours by pair_contours; a layer of one drawing alone grows from or shrinks to a point
/// of what lies there in the other. Corners of filled contours that both drawings share correspond, and
/// so stay where they are, unless a start is given. Contours are sampled by arc length, filled ones close, and
/// transformed down to four control points.
/// Throws std::invalid_argument for samples that are no power of two, 4 .. 2^24, a map, a start or
/// an anchor that fits no layer, contour or vertex, and a drawing without layers or with more than 10^4; std::domain_error for
/// contours that are more than 2^25 points together, or too many to be matched with each other: the
/// numbers of both drawings' contours and the samples have a product of at most 10^10.
Morph make_morph(const Drawing& source, const Drawing& destination, const MorphOptions& options);

}  // namespace wavecurve::motion
