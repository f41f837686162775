#pragma once

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"

namespace wavecurve {

/// The Fourier coefficients of a closed curve as complex numbers x + i y: z(t) = sum_k Z_k e^(i k t), with Z_k
/// at k, or k + N for negative k, and t = 2 pi i / N at point i.
Eigen::VectorXcd contour_spectrum(const Contour& points);

/// The inverse.
Contour contour_of_spectrum(const Eigen::VectorXcd& spectrum);

/// The frequency k, from -N / 2 to N / 2 - 1, of an entry.
inline Eigen::Index frequency(Eigen::Index entry, Eigen::Index size) {
  return entry < (size + 1) / 2 ? entry : entry - size;
}

/// The spectrum of e^(i angle) z(t + shift). That of the highest frequency of an even number of points is
/// shifted by its real part: the points do not say which sign it has.
Eigen::VectorXcd moved(const Eigen::VectorXcd& spectrum, double shift, double angle);

/// The spectrum without place and size: about the mean, with the mean squared distance 1 from it, that is
/// sum |Z_k|^2 = 1. Throws std::invalid_argument where all points are one.
Eigen::VectorXcd without_place_and_size(Eigen::VectorXcd spectrum);

/// How the first ellipse of a curve, Z_1 e^(it) + Z_-1 e^(-it), lies: moved() by these has both
/// coefficients real and not negative. So do shift + pi, angle + pi.
struct FirstEllipse {
  double shift = 0, angle = 0;
};
FirstEllipse first_ellipse(const Eigen::VectorXcd& spectrum);

}  // namespace wavecurve
