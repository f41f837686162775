#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/dynamics/initial_value_problem.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"

namespace wavecurve::verification {

/// What motions are compared on: curves released at rest, whose rest shape is the unit circle.
/// Points are at x = i / samples, i = 0, 1, ...
Contour unit_circle(Eigen::Index samples);

/// "ellipse", "star", "dent": smooth, smooth at a higher frequency, local.
const std::vector<std::string>& shape_names();

/// With theta = 2 pi x:
///   ellipse  (1.4 cos theta, 0.6 sin theta)
///   star     radius 1 + 0.3 cos 5 theta
///   dent     radius 1 - 0.6 exp(-((x - 0.3) / 0.05)^2), 0 <= x < 1
/// Throws std::invalid_argument for an unknown name, naming those there are.
Contour named_shape(std::string_view name, Eigen::Index samples);

/// A hoop of mean 0 out of shape, for the publication's, which are lost:
/// ((1.3 + w) cos theta, (0.65 + w) sin theta + 0.3 cos 2 theta), w = 0.12 cos 5 theta.
Contour deformed_hoop(Eigen::Index samples);

/// Any other contour, made comparable: mean 0, root mean square radius 1, and of all its points
/// that one first which makes it nearest to the circle. Throws std::invalid_argument if all points
/// coincide.
Contour fitted_to_circle(const Contour& contour);

/// The contour of that name, or the first of a drawing (.svg, .csv), fitted. Throws as named_shape
/// and io::read_drawing do.
Contour shape_of(const std::string& name_or_file, Eigen::Index samples);

/// The shape released at rest; samples are taken as coefficients, the displacement is what the
/// shape differs from the circle by.
dynamics::InitialValueProblem released(const dynamics::LagrangeSystem& system, const Contour& shape,
                                       const Eigen::Ref<const Eigen::VectorXd>& times);

}  // namespace wavecurve::verification
