#pragma once

#include <vector>

#include "wavecurve/certified/decimal_enclosure.hpp"
#include "wavecurve/certified/filter_definition.hpp"

namespace wavecurve::certified {

/// What certified_decimals() is asked for.
struct DecimalsRequest {
  int p = 1, q = 1;              ///< orders of the two derivatives, 0 .. 8
  int digits = 40;               ///< significant digits, at least 1
  bool divide_by_first = false;  ///< mu_l / mu_0 and nu_l / nu_0, as published tables print them
};

/// alpha_n, mu_l, nu_l for the indices 0, 1, 2, ... as decimals with proof. alpha and, for even
/// p + q, mu and nu are symmetric in the index; for odd p + q mu and nu are antisymmetric.
struct CoefficientDecimals {
  std::vector<DecimalEnclosure> alpha, mu, nu;
};

/// The autocorrelation alpha (filters/autocorrelation.hpp) and the connection coefficients mu, nu
/// (filters/connection_coefficients.hpp) of a filter, each correctly rounded to the digits asked
/// for: from exact fractions where there are any, else from enclosures at a precision that is
/// raised until every rounding is decided. Numbers that no precision decides, because the taps are
/// a user's own decimals, have as many digits as are proved, and the radius tells the rest.
///
///   certified_decimals(find_filter("coif2"), {.digits = 20}).mu[0].value
///
/// Throws std::invalid_argument for digits below 1, for derivative orders outside 0 .. 8, and for
/// divide_by_first with odd p + q, where the coefficient of index 0 is zero; std::domain_error,
/// naming the exponents, if the family is not smooth enough.
CoefficientDecimals certified_decimals(const FilterDefinition& definition,
                                       const DecimalsRequest& request = {});

}  // namespace wavecurve::certified
