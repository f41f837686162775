#pragma once

#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::io {

/// The box around the control points of all layers and half the width of their strokes; a box
/// without height or width gets the other one.
ViewBox fit_view_box(const Drawing& drawing);

}  // namespace wavecurve::io
