#pragma once

#include <vector>

#include "verification/routes/routes.hpp"

namespace wavecurve::verification {

/// Fewest and most decimals of a table of taps that a column may have been scaled from; the most if
/// double arithmetic, whose own errors are larger than a later rounding, is to show them.
inline constexpr int fewest_tap_decimals = 6, most_tap_decimals = 20, most_decimals_in_doubles = 13;

/// The routes to a column of taps in this normalization that start from a table of decimals: the
/// published one, or the true taps in one of the three normalizations, correctly rounded (proved)
/// to fewest_tap_decimals .. most_tap_decimals, where that changes them. It is taken as it stands and scaled by a power of
/// sqrt 2, or divided by its sum, or by its Euclidean norm (orthonormal filters only).
///
/// As a rounding rule its numbers r sqrt(q), with r and q rational,
/// are known exactly. "In double arithmetic", another entry of the list, they carry the rounding errors of that program, at
/// most u = 2^-53 for each of its operations: relative to the number,
///
///   scaled             4 u          the decimal, sqrt 2, a product, and one more product for sqrt 2
///   divided by sum     (T c + 6) u  T - 1 additions and the decimals, c = sum |g| / |sum g|
///   divided by norm    (T/2 + 8) u  half the error of the sum of T squares, a root, a division
std::vector<Route> tap_rules(const Quantity& column, const RouteInput& input);

}  // namespace wavecurve::verification
