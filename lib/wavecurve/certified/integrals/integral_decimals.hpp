#pragma once

#include <vector>

#include "wavecurve/certified/decimal_enclosure.hpp"
#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/integrals/product_integral.hpp"

namespace wavecurve::certified {

/// One integral, with the indices of its shifted factors.
struct IntegralDecimal {
  std::vector<int> indices;
  DecimalEnclosure number;
};

/// The integrals of certified/integrals/product_integrals.hpp as decimals, row by row, each
/// correctly rounded to this many significant digits. Exact zeros, as where the supports do not
/// meet, are left out, of one index those at either end; if all are zero, one is listed.
///
/// Two factors of one kind have exact fractions where connection_coefficients.hpp has them, and
/// those of the two sides of a bank, which are biorthogonal, are 0 and 1; any number of factors has
/// them where exact_integrals.hpp solves its system. Another integral that
/// vanishes is "0" with the radius that is proved, which is below 10^-(digits + 100) of the
/// largest. Numbers that a user's own decimals do not decide have as many digits as are proved.
///
/// Throws as product_integrals, and std::invalid_argument for digits below 1.
std::vector<IntegralDecimal> integral_decimals(const FilterDefinition& definition,
                                               const ProductIntegral& integral, int digits = 40);

}  // namespace wavecurve::certified
