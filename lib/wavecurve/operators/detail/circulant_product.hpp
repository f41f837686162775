#pragma once

#include <vector>

#include <Eigen/Core>

namespace wavecurve {

/// Rows of a banded circulant, symmetric (sign 1) or antisymmetric (sign -1):
///   out_i = weights_0 x_i + sum_{l > 0} weights_l (x_{i-l} + sign x_{i+l}),  i = 0 .. count - 1.
/// x holds weights.size() - 1 values in front of the first and behind the last as well; out does
/// not overlap it. Vectorised for the processor at hand, the same bits on all.
void circulant_product(const std::vector<double>& weights, int sign, const double* x,
                       Eigen::Index count, double* out);

}  // namespace wavecurve
