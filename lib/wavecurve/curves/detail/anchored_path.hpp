#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/curves/detail/arc_length.hpp"
#include "wavecurve/curves/path.hpp"

namespace wavecurve {

/// Where two segments of a path meet.
struct PathVertex {
  std::size_t number = 0;  ///< of the segment that starts here, in the path as it was given
  Eigen::Vector2d point;
  double length = 0;  ///< of the path from its start to here
  bool is_corner = false;
};

/// A subpath, closed as filling closes it, that is sampled from vertex to vertex.
class AnchoredPath {
 public:
  /// Run through in the direction of a contour of samples of it.
  /// Throws std::invalid_argument for a length that is zero or not finite.
  AnchoredPath(const Subpath& subpath, const Contour& samples);

  double length() const { return arc_.length(); }
  /// In the direction of the contour.
  const std::vector<PathVertex>& vertices() const { return vertices_; }

  /// The first of the points is the first anchor; counts[k] points, at equal distances along the path,
  /// lie from anchor k on before the next. Anchors are indices of vertices in their order around the
  /// path, from any of them on.
  Contour points(const std::vector<std::size_t>& anchors,
                 const std::vector<Eigen::Index>& counts) const;

  /// The lengths from each anchor to the next.
  std::vector<double> lengths_between(const std::vector<std::size_t>& anchors) const;

 private:
  std::vector<std::size_t> numbers_;
  Subpath closed_;
  ArcLength arc_;
  std::vector<PathVertex> vertices_;
};

}  // namespace wavecurve
