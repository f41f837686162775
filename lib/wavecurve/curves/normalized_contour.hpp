#pragma once

#include "wavecurve/curves/contour.hpp"

namespace wavecurve {

/// A closed curve without what does not belong to its shape, so that equal shapes have equal points: the
/// mean of the points is the origin, the mean of their squared distances from it 1, their order
/// clockwise as seen. Rotation and start are those of the first ellipse of the Fourier series (Kuhl and
/// Giardina 1982): its major axis lies along x, and the curve starts at one end of it, of the two the one
/// for which the sum of x^3 is not negative. Between the points given the start is found by the Fourier
/// series through them. A mirrored shape is another one. Where the first ellipse is a circle, as that of a
/// square, rotation and start are not determined.
/// Throws std::invalid_argument unless there are at least 4 points, not all one.
Contour normalized_contour(const Contour& points);

/// The root of the mean squared distance of the points from their mean, by which that is divided.
double contour_size(const Contour& points);

}  // namespace wavecurve
