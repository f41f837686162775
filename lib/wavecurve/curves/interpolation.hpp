#pragma once

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// The curve of finest coefficients c is f(t) = sum_n c_n phi(N t - n), N = c.rows(), indices of
/// period N. These are its points f(i / N), row i: c convolved with phi at the integers.
/// Throws std::domain_error where phi is not continuous, as scaling_values does.
Contour values_at_integers(const FilterBank<double>& bank, const Contour& finest);

/// The inverse: the finest coefficients whose curve passes through the points, f(i / N) = points_i.
/// The circulant of phi at the integers is solved by FFT, in O(N log N).
/// Throws std::domain_error naming the smallest modulus of the circulant's eigenvalues if it is
/// below 1e-6: so much of the points' rounding would be enlarged (splines of even order, 0).
Contour interpolate(const FilterBank<double>& bank, const Contour& points);

/// The smallest modulus of those eigenvalues, sum_k phi(k) exp(-2 pi i k l / N), l = 0 .. N - 1.
double smallest_symbol(const FilterBank<double>& bank, Eigen::Index samples);

}  // namespace wavecurve
