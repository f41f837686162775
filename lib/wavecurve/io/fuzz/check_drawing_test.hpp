#pragma once

#include <cmath>
#include <cstdlib>
#include <set>
#include <string>

#include "wavecurve/io/drawings/detail/svg/tidy_outline.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"

namespace wavecurve::io {

inline void demand(bool condition) {
  if (!condition) std::abort();
}

/// What every drawing promises, whatever it was read from.
inline void check_drawing(const Drawing& drawing) {
  demand(!drawing.layers.empty());
  std::set<std::string> ids;
  for (const Layer& layer : drawing.layers) {
    demand(ids.insert(layer.id).second);
    demand(layer.paint.fill || layer.paint.stroke);
    demand(!layer.subpaths.empty());
    for (const Subpath& subpath : layer.subpaths) {
      demand(!subpath.segments.empty());
      const BezierSegment* last = subpath.closed ? &subpath.segments.back() : nullptr;
      for (const BezierSegment& segment : subpath.segments) {
        demand(segment.degree() >= 1 && segment.degree() <= 3);
        demand(segment.control.cwiseAbs().maxCoeff() <= largest_coordinate);
        demand(!last || last->control.rightCols<1>() == segment.control.col(0));
        last = &segment;
      }
    }
  }
}

}  // namespace wavecurve::io
