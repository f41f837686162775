#pragma once

#include <cstddef>
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
/// Caps, joins and the fill rule are those of the key at or before a time. A layer has a fill, or a
/// stroke, in all of its paint keys or in none.
struct AnimatedLayer {
  std::string id;
  std::vector<OutlineKey> outline;
  std::vector<PaintKey> paint;
  /// Which contours are lines from their first point to the last, not joined; empty: none.
  std::vector<bool> open = {};
};

/// From a time on, the layers are painted in another order, or others are.
struct OrderKey {
  double time = 0;                 ///< seconds
  std::vector<std::size_t> order;  ///< indices of the layers that are there, the lowest first
};

/// A drawing whose outlines and paints are piecewise linear functions of time, for any player.
struct Animation {
  ViewBox view_box;
  double duration = 0;  ///< seconds
  std::vector<AnimatedLayer> layers;
  /// In increasing time; before the first, layers are painted as they stand, the lowest first.
  std::vector<OrderKey> order = {};
};

/// One layer of a still picture of an animation.
struct FrameLayer {
  std::string id;
  std::vector<Contour> contours;
  Paint paint;
  std::vector<bool> open = {};  ///< as in AnimatedLayer
};

/// Whether contour i of a layer is an open line.
template <class Layer>
bool is_open(const Layer& layer, std::size_t i) {
  return i < layer.open.size() && layer.open[i];
}

/// A layer at a time.
FrameLayer layer_at(const AnimatedLayer& layer, double time);

/// The indices of the layers that are there at a time, in painting order, the lowest first.
std::vector<std::size_t> order_at(const Animation& animation, double time);

/// The layers at a time, in painting order; what every renderer and test compares itself with.
std::vector<FrameLayer> frame_at(const Animation& animation, double time);

}  // namespace wavecurve::motion
