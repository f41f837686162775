#pragma once

#include <vector>

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// The mask of chi, whose d-fold backward difference is phi^(d):
///   chi(x) = sum_k mask_k chi(2x - k),
/// sqrt 2 synthesis_low divided by ((1 + z) / 2)^d, d taps shorter. Publication, (2.1).
/// Throws std::domain_error naming the Sobolev exponent where phi^(d) is not known to be a
/// function: d at or above that exponent or the vanishing moments; std::invalid_argument for d < 0.
std::vector<double> refinement_mask(const FilterBank<double>& bank, int d);

/// chi at 0 .. size - 1, with sum_l chi(l) = 1: the eigenvector of its mask for the eigenvalue 1.
/// Throws std::domain_error where the mask has fewer than three coefficients.
Eigen::VectorXd integer_values(const std::vector<double>& mask);

}  // namespace wavecurve
