#pragma once

#include <string>
#include <vector>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::motion {

/// The outline of a layer at a time: the same number of contours, with the same numbers of points,
/// in every key of the layer.
struct OutlineKey {
  double time = 0;  ///< seconds
  std::vector<Contour> contours;
};

struct PaintKey {
  double time = 0;  ///< seconds
  Paint paint;
};

/// Keys in increasing time; linear in between, constant before the first and after the last.
/// A layer has a fill, or a stroke, in all of its paint keys or in none.
struct AnimatedLayer {
  std::string id;
  std::vector<OutlineKey> outline;
  std::vector<PaintKey> paint;
};

/// A drawing whose outlines and paints are piecewise linear functions of time, for any player.
/// Layers in painting order, the lowest first.
struct Animation {
  ViewBox view_box;
  double duration = 0;  ///< seconds
  std::vector<AnimatedLayer> layers;
};

/// One layer of a still picture of an animation.
struct FrameLayer {
  std::string id;
  std::vector<Contour> contours;
  Paint paint;
};

/// The layers at a time; what every renderer and test compares itself with.
std::vector<FrameLayer> frame_at(const Animation& animation, double time);

}  // namespace wavecurve::motion
