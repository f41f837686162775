#include "verification/stand_ins/example_contour.hpp"

#include <cmath>

#include "wavecurve/curves/sample_contour.hpp"

#include "verification/stand_ins/example_drawing.hpp"

namespace wavecurve::verification {

Contour example_contour(std::string_view file_name, Eigen::Index samples) {
  const Drawing drawing = example_drawing(file_name);
  return sample_contour(drawing.layers.at(0).subpaths.at(0), samples);
}

double diagonal(const Contour& contour) {
  return (contour.colwise().maxCoeff() - contour.colwise().minCoeff()).norm();
}

double rms_distance(const Contour& a, const Contour& b) {
  // Summed in order, so that the figure is the same on every machine.
  double sum = 0;
  for (Eigen::Index i = 0; i < a.rows(); ++i) sum += (a.row(i) - b.row(i)).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.rows()));
}

}  // namespace wavecurve::verification
