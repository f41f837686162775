#pragma once

#include <functional>
#include <optional>
#include <string>

#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::io {

/// The size of a picture in pixels.
struct RasterSize {
  int width = 0, height = 0;
};

/// How an animation leaves; each format takes what concerns it.
struct OutputOptions {
  /// Frames, equidistant, the first at the beginning and the last at the end of the animation.
  int frames = 60;
  /// How far a point may be from the motion at any time, in units of the drawing: tolerance of fitted
  /// cubic Bezier curves (fit_cubics) and of fitted keys; 0: polygons, and all keys.
  double tolerance = 0;
  /// Accuracy of written coordinates, as a share of the longer side of the view box.
  double accuracy = 1e-4;
  /// Title of a page; empty: the name of the file.
  std::string title = {};
  /// Plays for ever, not once. There is no jump in an animation that went there_and_back, as a
  /// morph does for this.
  bool loop = false;
  /// Pixels of the longer side of a picture, where it has no size.
  int pixels = 512;
  /// Width and height of a picture, in the middle of which the drawing is as large as fits. A page is
  /// as large as its window.
  std::optional<RasterSize> size{};
  /// Behind the layers; none: nothing, but white in .gif, .mp4 and .webm.
  std::optional<Colour> background{};
  /// There is nothing behind the layers in .gif and .webm, nor on the page, where no background is.
  bool transparent = false;
  /// Called after each rendered frame with the number done and the number of all.
  std::function<void(int, int)> progress = {};
};

}  // namespace wavecurve::io
