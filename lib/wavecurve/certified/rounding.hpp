#pragma once

#include <optional>
#include <string>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/rational.hpp"

namespace wavecurve::certified {

// Correct rounding, proved: each function answers only if every number in the enclosure rounds to
// the same result, and returns nothing otherwise (raise the precision and ask again). A rational
// number always rounds; ties go to the even digit, as in IEEE 754.

/// The nearest decimal with this many digits behind the point, such as "-0.333333333333".
/// Zero has no sign. Throws std::invalid_argument if decimals < 0.
std::optional<std::string> round_to_decimals(const Ball& x, int decimals);
std::string round_to_decimals(const Rational& x, int decimals);

/// The nearest decimal of this many significant digits, fixed from 1e-5 to 1e15, else scientific
/// ("1.25e-17"). Zero is "0". Throws std::invalid_argument if digits < 1.
std::optional<std::string> round_to_digits(const Ball& x, int digits);
std::string round_to_digits(const Rational& x, int digits);

/// A working precision that mostly decides the rounding to this many significant digits.
long bits_for_digits(int digits);

/// The nearest double, the nearest float.
std::optional<double> round_to_double(const Ball& x);
std::optional<float> round_to_float(const Ball& x);

/// An upper bound of |x| as a short decimal, one digit rounded up: "3e-41"; "0" for exact zero.
std::string magnitude_bound(const Ball& x);

}  // namespace wavecurve::certified
