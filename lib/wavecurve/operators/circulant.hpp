#pragma once

#include <Eigen/Core>

#include "wavecurve/filters/filter.hpp"

namespace wavecurve {

/// The first column of the operator of derivative orders (p, q), d = p + q, on the periodized
/// scaling functions 2^{J/2} phi(2^J x - n) of the finest level, samples = 2^J:
///   entry (i, j) = column_{(i - j) mod samples},  column_r = 2^{J d} sum_k mu_{r + k samples},
/// where the support exceeds the period as well. The symmetry of mu, (-1)^d, is kept exactly.
/// Throws std::invalid_argument unless samples is a power of two, 1 .. 2^24.
Eigen::VectorXd circulant_column(const Filter<double>& mu, Eigen::Index samples, int d);

/// The eigenvalues of that circulant for even d, by frequency k = 0 .. samples - 1:
///   lambda_k = 2^{J d} sum_l mu_l cos(2 pi k l / samples),
/// those of k and of samples - k being the same; lambda_0 = 0 exactly for d > 0. With d = 2 the
/// relative error is a few units of rounding at every frequency, since sum mu_l = 0 is used.
/// Throws std::invalid_argument for an odd d, and as circulant_column does.
Eigen::VectorXd circulant_eigenvalues(const Filter<double>& mu, Eigen::Index samples, int d);

/// The same, by frequency k = 0 .. samples / 2 only, for symmetric mu; a sine and a cosine each.
Eigen::VectorXd circulant_symbol(const Filter<double>& mu, Eigen::Index samples, int d);

}  // namespace wavecurve
