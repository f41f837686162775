#pragma once

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// How the finest coefficients c of a curve follow from its N samples.
///
/// In both, the curve is f(t) = sum_n c_n phi(N t - n), with int phi = 1 and indices of period N:
/// c is in the units of the drawing. The publication's functions (2.5) are scaled,
/// phi~_n^{M_f} = sqrt N phi(N t - n) with N = 2^{-M_f}, hence c_n^{M_f} = c_n / sqrt N, and every
/// coefficient of the transform here is sqrt N times the publication's.
enum class SampleMode {
  /// c_n = sample n, the publication's. The curve runs near the samples, at sample n for
  /// t = (n + m) / N, m = centre_of_phi: late by that much, and off by the order of the
  /// family.
  samples,
  /// The c whose curve passes through sample n at t = n / N.
  interpolate,
};

/// m = int x phi(x) dx = sum_n n synthesis_low_n / sqrt 2.
double centre_of_phi(const FilterBank<double>& bank);

/// Samples to coefficients in global-to-local order (see Band), one a row, columns x and y.
/// Publication, (2.8), (2.10)-(2.12). Throws std::invalid_argument as multiscale_bands does, and
/// std::domain_error as interpolate does.
Contour to_coefficients(const FilterBank<double>& bank, const Contour& samples, int levels,
                        SampleMode mode = SampleMode::samples);

/// The inverse, (2.9): the samples of the mode.
Contour to_samples(const FilterBank<double>& bank, const Contour& coefficients, int levels,
                   SampleMode mode = SampleMode::samples);

/// The same curve without its details: every row from `scale` on zero.
/// Throws std::invalid_argument unless scale is from 1 to the number of rows.
Contour approximation(const Contour& coefficients, Eigen::Index scale);

}  // namespace wavecurve
