#pragma once

#include <algorithm>
#include <vector>

#include "wavecurve/integrals/product_integral.hpp"

namespace wavecurve {

/// A number numerator / denominator.
struct NeededExponent {
  int numerator = 0, denominator = 1;
};

/// The Sobolev exponent that a scaling function must exceed for the integral of a product of its
/// derivatives to exist by the condition (E) of certified/integrals/product_integrals.hpp, where
/// factors have the exponents s - d_i: the largest ((m - 2)/2 + sum of the m largest d_i) / m, m >=
/// 2; an interval is one more factor, of exponent 1/2, by which m = 1 counts as well.
inline NeededExponent needed_exponent(const ProductIntegral& integral) {
  std::vector<int> derivatives;
  for (const IntegralFactor& factor : integral.factors) {
    derivatives.push_back(factor.function.derivative);
  }
  std::sort(derivatives.rbegin(), derivatives.rend());
  NeededExponent needed{-highest_derivative, 1};
  int sum = 0;
  for (int m = 1; m <= static_cast<int>(derivatives.size()); ++m) {
    sum += derivatives[static_cast<std::size_t>(m - 1)];
    const NeededExponent one{m - 2 + 2 * sum, 2 * m};
    const bool counts = m >= 2 || integral.interval.has_value();
    if (counts && one.numerator * needed.denominator > needed.numerator * one.denominator) {
      needed = one;
    }
  }
  return needed;
}

}  // namespace wavecurve
