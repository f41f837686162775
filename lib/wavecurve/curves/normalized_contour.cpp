#include "wavecurve/curves/normalized_contour.hpp"

#include <cmath>
#include <numbers>

#include "wavecurve/curves/detail/contour_spectrum.hpp"
#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

double contour_size(const Contour& points) {
  const Contour about_mean = points.rowwise() - points.colwise().mean();
  return std::sqrt(about_mean.rowwise().squaredNorm().mean());
}

Contour normalized_contour(const Contour& points) {
  check_at_least("the number of points", points.rows(), 4);
  Contour clockwise = points;
  if (signed_area(points) < 0) clockwise = points.colwise().reverse();
  const Eigen::VectorXcd spectrum = without_place_and_size(contour_spectrum(clockwise));
  const FirstEllipse ellipse = first_ellipse(spectrum);
  const auto from = [&](double turn) {
    return contour_of_spectrum(moved(spectrum, ellipse.shift + turn, ellipse.angle + turn));
  };
  const Contour result = from(0);
  return result.col(0).array().cube().sum() < 0 ? from(std::numbers::pi) : result;
}

}  // namespace wavecurve
