#pragma once

#include <optional>
#include <vector>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::motion {

/// Contours that are turned so that outer ones are clockwise and holes are not, and the rules that
/// fill them as the outline's own rule filled it.
struct Orientation {
  std::vector<Contour> contours;
  bool nonzero = true, evenodd = true;
};

/// An outline with outer contours clockwise and holes counter-clockwise. Contours may be reversed,
/// their first points and the shape stay. Without a rule, as in what is only stroked, nothing is a
/// hole.
///
/// Contours that cross themselves or each other keep their winding numbers under the nonzero rule,
/// up to a sign that they have in common; under the evenodd rule they stay as they are, and only
/// that rule fills them. Where the pairs of contours whose boxes meet have more than `most_plain`
/// points together, none are taken to cross, and a line sweeps over them: N log N operations for N
/// points.
Orientation oriented(std::vector<Contour> outline, std::optional<FillRule> rule,
                     double most_plain = 1e7);

}  // namespace wavecurve::motion
