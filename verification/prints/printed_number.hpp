#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "wavecurve/certified/rational.hpp"

namespace wavecurve::verification {

/// A number as it is printed: every digit that stands there, not only its value.
///
/// The value of a decimal is (-1)^negative * 0.digits * 10^(integer_digits + exponent), the unit of
/// its last digit 10^-decimals(). "-0.0125" has digits "00125" and integer_digits 1; ".5" is taken
/// as "0.5", "007.5" as "7.5".
///
/// A fraction, digits / denominator, is its value exactly: it has no last digit, its unit is zero,
/// and what is said of decimals and significant digits does not concern it.
struct PrintedNumber {
  bool negative = false;
  std::string digits;           ///< of the mantissa, zeros behind the point included
  int integer_digits = 1;       ///< how many of them stand before the point, at least one
  std::optional<int> exponent;  ///< of scientific notation
  std::string denominator{};    ///< of a fraction: its digits; empty for a decimal

  bool is_scientific() const { return exponent.has_value(); }
  bool is_fraction() const { return !denominator.empty(); }
  bool is_zero() const { return digits.find_first_not_of('0') == std::string::npos; }
  /// A single "0", as tables print what is zero by structure.
  bool is_bare_zero() const {
    return digits == "0" && !negative && !is_scientific() && !is_fraction();
  }
  /// Digits behind the point in fixed notation; negative if the last digit stands for tens or more.
  int decimals() const;
  /// Digits from the first that is not zero on; of a zero, all of them.
  int significant_digits() const;
  /// The digits from the first that is not zero on; empty for zero.
  std::string_view significand() const;
  /// The mantissa without sign, such as "0.0125".
  std::string mantissa() const;
  /// The number as text, in the same notation: "-0.0125", "1.25e-7", "75/64".
  std::string text() const;

  certified::Rational value() const;
  /// The unit of the last digit; zero for a fraction.
  certified::Rational unit() const;
  /// The double nearest the value.
  double to_double() const;

  bool operator==(const PrintedNumber&) const = default;
};

/// The most significant digits that are taken; the largest exponent, and the most zeros between the
/// point and the first of them: beyond any table, and few enough that a hostile file costs nothing.
inline constexpr int most_printed_digits = 200;
inline constexpr int largest_printed_exponent = 400;

/// What stands between the units and the tenths.
enum class DecimalMark { point, comma };

/// Reads a number in any form that tables, papers and programs have:
///
///   fixed         -0.25  .5  3.  +0.5  0005.25
///   exponents     1.2e-7  1.2E-07  1.2d-7  1.2D-07  1.2q-7  1.2-107 (Fortran's, of three digits)
///                 1.2*10^-7  1.2x10^-7  1.2*10**-7  1.2*^-7  1.2(-7)
///   fractions     75/64  -3./4.  3.0d0/4.0d0, of whole numbers
///   groups        5.267 857  12'345.6  5.267_857: before the point of three digits, behind it of
///                 three or more and alike up to the last
///   suffixes      0.34f  0.34L  0.34d  0.34q  0.34f32  0.34_dp  0.34_8  0.34`15
///   typeset       what number_forms.hpp knows: minus signs, dashes and blanks of Unicode, × 10⁻³,
///                 ½, TeX ($-1.2\times10^{-7}$, 5.267\,857, \frac{75}{64})
///
/// With DecimalMark::comma a number may have one comma, and then no point. Throws
/// std::invalid_argument saying what is wrong, also where a text may mean two things ("5.3(2)": an
/// exponent or an uncertainty); a long text is not repeated.
PrintedNumber parse_printed_number(std::string_view text, DecimalMark mark = DecimalMark::point);

/// The text in quotes as a message may repeat it: short, on one line, printable.
std::string excerpt(std::string_view text);

/// '0' to '9', whatever the locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// 10^exponent.
certified::Rational power_of_ten(int exponent);

}  // namespace wavecurve::verification
