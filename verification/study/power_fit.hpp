#pragma once

#include <cstddef>
#include <vector>

namespace wavecurve::verification {

/// y = factor x^exponent, by least squares of the logarithms. The exponent of a model that holds
/// but for independent deviations lies between low and high with a probability of 95 % (Student's
/// distribution with points - 2 degrees of freedom). Few points mean a wide interval.
struct PowerFit {
  double exponent = 0, low = 0, high = 0;
  std::size_t points = 0;
};

/// Throws std::invalid_argument unless there are at least 3 pairs, all above 0, of at least 2
/// different x.
PowerFit fit_power(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace wavecurve::verification
