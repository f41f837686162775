#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "wavecurve/certified/rational.hpp"

namespace wavecurve::verification {

/// A decimal as it is printed: every digit that stands there, not only its value.
///
/// The value is (-1)^negative * 0.digits * 10^(integer_digits + exponent), the unit of the last
/// digit 10^-decimals(). "-0.0125" has digits "00125" and integer_digits 1; ".5" is taken as "0.5".
struct PrintedNumber {
  bool negative = false;
  std::string digits;           ///< of the mantissa, leading and trailing zeros included
  int integer_digits = 1;       ///< how many of them stand before the point, at least one
  std::optional<int> exponent;  ///< of scientific notation

  bool is_scientific() const { return exponent.has_value(); }
  bool is_zero() const { return digits.find_first_not_of('0') == std::string::npos; }
  /// A single "0", as tables print what is zero by structure.
  bool is_bare_zero() const { return digits == "0" && !negative && !is_scientific(); }
  /// Digits behind the point in fixed notation; negative if the last digit stands for tens or more.
  int decimals() const;
  /// Digits from the first that is not zero on; of a zero, all of them.
  int significant_digits() const;
  /// The digits from the first that is not zero on; empty for zero.
  std::string_view significand() const;
  /// The mantissa without sign, such as "0.0125".
  std::string mantissa() const;
  /// The number as text, in the same notation.
  std::string text() const;

  certified::Rational value() const;
  certified::Rational unit() const;
  /// The double nearest the value.
  double to_double() const;

  bool operator==(const PrintedNumber&) const = default;
};

/// Longest print that is taken, and the largest exponent: beyond any table, and small enough that a
/// hostile file costs nothing.
inline constexpr int most_printed_digits = 200;
inline constexpr int largest_printed_exponent = 400;

/// Reads fixed ("-0.25", ".5", "3") or scientific ("1.2e-7", "1.2E-07") notation; a minus may also
/// be U+2212, as in typeset text. Throws std::invalid_argument saying what is wrong; a long text is
/// not repeated.
PrintedNumber parse_printed_number(std::string_view text);

/// The text in quotes as a message may repeat it: short, on one line, printable.
std::string excerpt(std::string_view text);

/// '0' to '9', whatever the locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// 10^exponent.
certified::Rational power_of_ten(int exponent);

}  // namespace wavecurve::verification
