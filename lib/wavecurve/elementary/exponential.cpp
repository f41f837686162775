#include "wavecurve/elementary/exponential.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "wavecurve/elementary/detail/elementary_kernels.hpp"
#include "wavecurve/elementary/detail/elementary_tables.hpp"
#include "wavecurve/elementary/detail/reduced.hpp"
#include "wavecurve/elementary/detail/round_to_integer.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"

namespace wavecurve {

namespace {

using elementary::integer_shift;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// 2^k for k + integer_shift, k from -1022 to 1023.
double power_of_two(double shifted) {
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) << 52) +
                               std::bit_cast<std::uint64_t>(1.0));
}

/// e^x = 2^k (head + tail).
struct ScaledExponential {
  double k;
  elementary::Sum<double> sum;
};

ScaledExponential scaled_exponential(double x) {
  const double k = (x * elementary::one_over_log_2 + integer_shift) - integer_shift;
  // The high part of log(2) has 42 bits: its product with |k| <= 1076 is exact, and so is the
  // difference, which is below 1/2 and a multiple of 2^-54, as both of them are unless k is 0.
  const double above = x - k * elementary::log_2_head, below = k * elementary::log_2_tail;
  const double r = above - below;
  return {k, elementary::reduced_exponential(elementary::exponential_polynomial, r,
                                             (above - r) - below)};
}

}  // namespace

double exponential(double x) {
  if (std::isnan(x)) return none;
  x = x < elementary::least_exponent ? elementary::least_exponent : x;
  x = x > elementary::largest_exponent ? elementary::largest_exponent : x;
  const auto [k, sum] = scaled_exponential(x);
  // 2^k itself may be no double, and a product rounds once only.
  const double shifted = k * 0.5 + integer_shift, rest = k - (shifted - integer_shift);
  return ((sum.head + sum.tail) * power_of_two(shifted)) * power_of_two(rest + integer_shift);
}

double exponential_minus_one(double x) {
  if (std::isnan(x)) return none;
  if (x < -40) return -1;  // e^-40 is below a quarter of a unit
  if (x > 100) return exponential(x);
  const auto [k, sum] = scaled_exponential(x);
  // Without a scale, x + x^2 E(x): the sum 1 + x would have lost the last bits of x.
  if (k == 0) {
    if (x == 0) return x;
    const auto small =
        elementary::reduced_exponential_minus_one(elementary::exponential_polynomial, x);
    return small.head + small.tail;
  }
  const double scale = power_of_two(k + integer_shift);
  const double head = scale * sum.head, tail = scale * sum.tail;
  const auto difference = head > 1 ? elementary::compensated_sum(head, -1.0, tail)
                                   : elementary::compensated_sum(-1.0, head, tail);
  return difference.head + difference.tail;
}

std::complex<double> exponential(const std::complex<double>& z) {
  const double size = exponential(z.real());
  if (z.imag() == 0) return {size, z.imag()};
  const auto [sine, cosine] = sine_cosine(z.imag());
  return {size * cosine, size * sine};
}

std::complex<double> hyperbolic_sine(const std::complex<double>& z) {
  const double size = std::abs(z.real());
  // sinh x = (e + e / (1 + e)) / 2 and cosh x = 1 + e^2 / (2 (1 + e)) with e = e^x - 1 >= 0: sums of
  // what is positive. Where e^2 would overflow, both are e / 2 long since.
  const double e = exponential_minus_one(size);
  const double sinh = size > 40 ? 0.5 * e : 0.5 * (e + e / (1 + e));
  const double cosh = size > 40 ? 0.5 * e : 1 + e * e / (2 * (1 + e));
  const auto [sine, cosine] = sine_cosine(z.imag());
  return {std::copysign(sinh, z.real()) * cosine, cosh * sine};
}

void exponential(const Eigen::Ref<const Eigen::ArrayXd>& x, Eigen::Ref<Eigen::ArrayXd> result) {
  elementary::check_sizes("exponential", x.size(), result.size());
  elementary::exponential_of_array(x.data(), x.size(), result.data());
}

}  // namespace wavecurve
