#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "wavecurve/certified/ball.hpp"

namespace wavecurve {

/// How far a value is from the true one, in units in the last place of the latter; below 2^-1022 in
/// units of 2^-1074.
inline double units_from(double value, const certified::Ball& truth) {
  const double size = std::abs(truth.to_double());
  const double unit = std::ldexp(1.0, std::max(std::ilogb(size), -1022) - 52);
  // The error is formed in units, for it may be below the least double.
  certified::Ball error = certified::Ball::from_double(value) - truth;
  error /= certified::Ball::from_double(unit);
  return std::abs(error.to_double());
}

inline std::vector<std::uint64_t> bits_of(const std::vector<double>& values) {
  std::vector<std::uint64_t> bits;
  for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
  return bits;
}

/// Numbers of all sizes from 2^least to 2^most and both signs.
inline std::vector<double> numbers_of_all_sizes(int count, int least, int most) {
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> fraction(1, 2);
  std::uniform_int_distribution<int> exponent(least, most - 1);
  std::vector<double> numbers;
  for (int i = 0; i < count; ++i) {
    const double size = std::ldexp(fraction(random), exponent(random));
    numbers.push_back(i % 2 == 0 ? size : -size);
  }
  return numbers;
}

}  // namespace wavecurve
