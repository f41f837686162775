#pragma once

#include <functional>
#include <string>

#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::io {

/// How an animation leaves; each format takes what concerns it.
struct OutputOptions {
  /// Frames, equidistant, the first at the beginning and the last at the end of the animation.
  int frames = 60;
  /// Tolerance of fitted cubic Bezier curves (fit_cubics), in units of the drawing; 0: polygons.
  double tolerance = 0;
  /// Accuracy of written coordinates, as a share of the longer side of the view box.
  double accuracy = 1e-4;
  /// Title of a page; empty: the name of the file.
  std::string title = {};
  /// Plays for ever, not once. There is no jump in an animation that went there_and_back, as a
  /// morph does for this.
  bool loop = false;
  /// Pixels of the longer side of a rendered frame.
  int pixels = 512;
  /// Behind the layers, in formats that are not transparent.
  Colour background{1, 1, 1};
  /// Called after each rendered frame with the number done and the number of all.
  std::function<void(int, int)> progress = {};
};

}  // namespace wavecurve::io
