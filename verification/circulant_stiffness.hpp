#pragma once

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve::verification {

/// The stiffness matrix of a single scale, N x N, e_0 = 1, on the unit interval:
///   K_ij = N^2 sum_k mu_{i - j + k N},
/// a symmetric circulant whose null space is spanned by the constants. Publication, (3.8).
/// Throws as connection_coefficients does, and std::invalid_argument for samples < 1.
Eigen::MatrixXd circulant_stiffness(const FilterBank<double>& bank, int samples);

}  // namespace wavecurve::verification
