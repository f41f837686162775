#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/curves/path.hpp"
#include "wavecurve/motion/morph/morph.hpp"

namespace wavecurve::motion {

/// Vertices of two subpaths, by the numbers of the segments that start there.
using VertexPairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// A subpath and points sampled along it.
struct SampledPath {
  const Subpath& path;
  const Contour& points;
};

/// Corresponding points of two contours, as many as these have, of which given vertices correspond:
/// between two of them the points are equidistant on either contour, as many as the mean of the shares
/// of the whole length asks for.
///
/// Without vertices those that correspond are the corners that both contours share: corners of both
/// within the distance, as many as follow each other around both. None where there is none.
/// Throws std::invalid_argument where a contour has no vertex of the number, or where the vertices do
/// not follow each other around both.
std::optional<ContourPair> held_pair(const SampledPath& source, const SampledPath& destination,
                                     const VertexPairs& vertices, double distance);

/// The pairs of contours of two layers whose vertices are held: those of the anchors, which are counted
/// through all contours of a layer, or the corners that both share where there are no anchors.
class HeldVertices {
 public:
  HeldVertices(const Layer& source, const Layer& destination, VertexPairs anchors, double distance);

  /// As held_pair. Without anchors none of lines, which correspond by their ends, and of what is stroked,
  /// whose corners are samples already.
  std::optional<ContourPair> pair(const FrameLayer& from, const FrameLayer& to, std::size_t i,
                                  std::size_t j);

  bool has_anchors() const { return !anchors_.empty(); }

  /// Throws std::invalid_argument unless each anchor was of a pair.
  void check_found() const;

 private:
  const Layer &source_, &destination_;
  VertexPairs anchors_;
  double distance_;
  std::size_t found_ = 0;
};

}  // namespace wavecurve::motion
