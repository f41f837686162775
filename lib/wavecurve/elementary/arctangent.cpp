#include "wavecurve/elementary/arctangent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wavecurve/elementary/detail/elementary_tables.hpp"
#include "wavecurve/elementary/detail/exact_product.hpp"
#include "wavecurve/elementary/detail/reduced.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"

namespace wavecurve {

namespace {

using elementary::Sum;

/// The arctangent of smaller / larger, both at least 0, the quotient at most 1.
Sum<double> arctangent_of_quotient(double smaller, double larger) {
  if (smaller == larger && smaller > 0) smaller = larger = 1;  // both may be infinite
  if (smaller == 0) return {0, 0};
  const double q = smaller / larger;
  if (q < 0x1p-30) return {q, 0};  // arctan(q) = q (1 - q^2 / 3)
  // The quotient's remainder is a double, and its quotient the part of q that was rounded off.
  const int exponent = std::ilogb(larger);
  const double d = std::ldexp(larger, -exponent), n = std::ldexp(smaller, -exponent);
  const double product = q * d;
  const double low = ((n - product) - elementary::product_error(q, d, product)) / d;
  const int j = static_cast<int>(32 * q + 0.5);
  if (j < elementary::first_arctangent) {
    return {q, elementary::small_arctangent_tail(elementary::arctangent_polynomial, q, low)};
  }
  const auto i = static_cast<std::size_t>(j - elementary::first_arctangent);
  const double head = elementary::arctangent_heads[i], rest = elementary::arctangent_tails[i];
  return {head,
          elementary::arctangent_tail(elementary::arctangent_polynomial, j / 32.0, rest, q, low)};
}

}  // namespace

double arctangent(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  const double across = std::abs(x), up = std::abs(y);
  const bool is_steep = up > across, is_left = std::signbit(x);
  Sum<double> angle = arctangent_of_quotient(std::min(across, up), std::max(across, up));
  if (is_steep || is_left) {
    // pi/2 - a, pi/2 + a or pi - a.
    const double turns = is_steep ? 1 : 2, sign = is_steep && is_left ? 1 : -1;
    angle = elementary::compensated_sum(turns * elementary::half_pi_head, sign * angle.head,
                                        turns * elementary::half_pi_tail + sign * angle.tail);
  }
  return std::copysign(angle.head + angle.tail, y);
}

double arccosine(double x) { return arctangent(std::sqrt((1 - x) * (1 + x)), x); }

double tangent(double x) {
  const auto [sine, cosine] = sine_cosine(x);
  return sine / cosine;
}

}  // namespace wavecurve
