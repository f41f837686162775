#include "wavecurve/elementary/logarithm.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "wavecurve/elementary/detail/elementary_tables.hpp"
#include "wavecurve/elementary/detail/reduced.hpp"

namespace wavecurve {

double logarithm(double x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (x == 0) return -infinity;
  if (!(x > 0)) return std::numeric_limits<double>::quiet_NaN();
  if (x == infinity) return infinity;
  int k;
  double m = std::frexp(x, &k);
  if (m < 11.0 / 16) {
    m *= 2;
    --k;
  }
  const auto sum =
      elementary::reduced_logarithm(elementary::logarithm_polynomial, m - 1,
                                    k * elementary::log_2_head, k * elementary::log_2_tail);
  return sum.head + sum.tail;
}

double logarithm_10(double x) {
  const double quotient = logarithm(x) / std::numbers::ln10;
  const double nearest = std::nearbyint(quotient);
  // The powers of ten that are doubles: their logarithms are whole, and decisions hang on it.
  if (nearest < 0 || nearest > 22 || std::abs(quotient - nearest) > 1e-14) return quotient;
  double power = 1;
  for (int i = 0; i < static_cast<int>(nearest); ++i) power *= 10;
  return power == x ? nearest : quotient;
}

}  // namespace wavecurve
