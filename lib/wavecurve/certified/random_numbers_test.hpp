#pragma once

#include <array>
#include <cstdint>
#include <random>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/rational.hpp"

namespace wavecurve::certified {

inline constexpr int random_cases = 10000;

/// Numbers for tests, the corners favoured; the same in every run.
class RandomNumbers {
 public:
  long integer(long lowest, long highest) {
    return std::uniform_int_distribution<long>(lowest, highest)(engine_);
  }
  bool one_in(long n) { return integer(1, n) == 1; }

  /// At most 62 bits, every magnitude, either sign; often 0, 1 or the largest.
  long whole() {
    constexpr long largest = (1L << 62) - 1;
    constexpr std::array corners{0L, 1L, 2L, (1L << 31) - 1, 1L << 32, largest};
    const long magnitude = one_in(3) ? corners[static_cast<std::size_t>(integer(0, 5))]
                                     : integer(0, largest) >> integer(0, 61);
    return one_in(2) ? magnitude : -magnitude;
  }

  /// Zero, small fractions, long fractions, and those of magnitudes 2^-300 to 2^300.
  Rational rational() {
    switch (integer(0, 5)) {
      case 0:
        return {integer(-3, 3), integer(1, 4)};
      case 1:
        return Rational(whole()) * Rational::power_of_two(integer(-300, 300));
      case 2:
        return power(whole()) / power(nonzero());
      default:
        return {whole(), nonzero()};
    }
  }

  /// Exact, narrow, or wide, also wider than its midpoint.
  Ball ball() {
    switch (integer(0, 3)) {
      case 0:
        return Ball(integer(-3, 3));
      case 1:
        return Ball(rational());
      case 2:
        return Ball::around(rational(), rational().abs());
      default:
        return narrow_ball();
    }
  }

 private:
  long nonzero() {
    const long n = whole();
    return n == 0 ? 1 : n;
  }
  static Rational power(long base) { return Rational(base) * Rational(base) * Rational(base); }
  Ball narrow_ball() {
    const Rational middle = rational();
    return Ball::around(middle, middle.abs() * Rational::power_of_two(integer(-120, -1)));
  }

  std::mt19937_64 engine_{20240517};
};

/// A midpoint, a radius or any other exact ball as a fraction.
inline Rational exact_value(const Ball& exact) {
  Rational value;
  arf_get_fmpq(value.get(), arb_midref(exact.get()));
  return value;
}

}  // namespace wavecurve::certified
