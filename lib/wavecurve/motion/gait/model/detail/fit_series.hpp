#pragma once

#include <vector>

#include <Eigen/Core>

#include "wavecurve/motion/gait/model/phase_data.hpp"

namespace wavecurve::gait {

/// Coefficients of polynomials of a degree, 2 .. 6, through the key frames of each run: the rows
/// of PhaseMotion's `degree d`, one column a coefficient; sum of squares over all runs, least.
/// By the normal equations of the basis, which are as few as the degree less one, for all columns
/// at once. A basis with more terms than there are frames is shortened; what is left out is 0.
Eigen::MatrixXd fit_polynomial(const PhaseData& data, int degree);

/// The periodic series of PhaseMotion's `fourier` with the given number of terms (odd), through the
/// frames of all phases of a limb, each at its share of the cycle; no key frames.
Eigen::MatrixXd fit_fourier(const std::vector<PhaseData>& phases, int terms);

}  // namespace wavecurve::gait

namespace wavecurve::gait::plain {

/// The same by Householder's QR of the whole system, each column by itself.
Eigen::MatrixXd fit_polynomial(const PhaseData& data, int degree);
Eigen::MatrixXd fit_fourier(const std::vector<PhaseData>& phases, int terms);

}  // namespace wavecurve::gait::plain
