#pragma once

#include <string_view>

#include "wavecurve/curves/contour.hpp"

namespace wavecurve::verification {

/// The first contour of a drawing in docs/examples, sampled uniformly in arc length.
Contour example_contour(std::string_view file_name, Eigen::Index samples);

/// The diagonal of the bounding box.
double diagonal(const Contour& contour);

/// The root of the mean squared distance of the points with the same index.
double rms_distance(const Contour& a, const Contour& b);

}  // namespace wavecurve::verification
