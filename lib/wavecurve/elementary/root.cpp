#include "wavecurve/elementary/root.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "wavecurve/elementary/detail/exact_product.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

double whole_power(double x, int n) {
  double power = n > 0 ? x : 1;
  for (int i = 1; i < n; ++i) power *= x;
  return power;
}

namespace {

/// One step of Newton's more from a value next to the root, with the power y^n in twice the digits:
/// what it leaves is the rounding of the last sum.
double corrected(double y, double x, int n) {
  double power = y, error = 0;
  for (int i = 1; i < n; ++i) {
    const double next = power * y;
    error = error * y + elementary::product_error(power, y, next);
    power = next;
  }
  return y + ((x - power) - error) / (n * whole_power(y, n - 1));
}

}  // namespace

double power_of_root_two(int k) {
  const int half = k >= 0 ? k / 2 : -((1 - k) / 2);
  return std::ldexp(k % 2 == 0 ? 1 : std::numbers::sqrt2, half);
}

double root(double x, int n) {
  check_between("n of a root", n, 2, 16);
  if (x < 0 && n % 2 != 0) return -root(-x, n);
  if (!(x >= 0)) return std::numeric_limits<double>::quiet_NaN();
  if (x == 0 || std::isinf(x)) return x;
  // x = m 2^(n e) with 1/2^n <= m < 1, so that no power of a value in between overflows.
  int exponent;
  std::frexp(x, &exponent);
  const int e = exponent > 0 ? (exponent + n - 1) / n : -(-exponent / n);
  const double m = std::ldexp(x, -n * e);
  // From above, Newton's values fall until rounding is all that is left.
  double y = 1;
  while (true) {
    const double next = y + (m / whole_power(y, n - 1) - y) / n;
    if (!(next < y)) return std::ldexp(corrected(y, m, n), e);
    y = next;
  }
}

}  // namespace wavecurve
