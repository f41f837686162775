#pragma once

#include <functional>
#include <optional>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/rational.hpp"

#include "verification/prints/printed_number.hpp"

namespace wavecurve::verification {

/// The precision at which a rounding that is still open is reported as undecided.
inline constexpr long precision_limit_bits = 4096;

/// A number that can be enclosed as tightly as one likes, or is known exactly.
struct TrueValue {
  std::optional<certified::Rational> exact;
  std::function<certified::Ball(long bits)> enclosure;  ///< set where `exact` is not

  bool is_exactly_zero() const { return exact && exact->is_zero(); }
  double to_double() const;
};

/// A number as the sum of two doubles and what that may be off: enough to see that two numbers are
/// apart without asking for enclosures.
struct Approximation {
  double head = 0, tail = 0, error = 0;
};
Approximation approximate(const TrueValue& value);

/// |a - b|, up to the sum of their errors.
double apart(const Approximation& a, const Approximation& b);

/// The number that a double is.
TrueValue exactly(double number);

/// The value times the square root of a number >= 0; exact if both are.
TrueValue times_root(const TrueValue& value, const certified::Rational& square);

enum class Decision { no, yes, undecided };

/// Asks with ever tighter enclosures, from 128 bits to precision_limit_bits, until the answer is
/// there (certified/refine.hpp).
Decision decide(const TrueValue& value, const std::function<Decision(const certified::Ball&)>& ask);

/// Is |value - number| <= radius? Proved.
Decision is_within(const TrueValue& value, const certified::Rational& number,
                   const certified::Rational& radius);

/// Is the number what is left of the value if the digits after 10^-decimals are left away? Then it
/// lies between zero and the value, and less than one unit from it. Proved.
Decision is_cut_off(const TrueValue& value, const certified::Rational& number, int decimals);

/// The value correctly rounded to this many decimals, or to this many significant digits; nothing
/// if undecided at the limit.
std::optional<PrintedNumber> round_to_decimals(const TrueValue& value, int decimals);
std::optional<PrintedNumber> round_to_digits(const TrueValue& value, int digits);

}  // namespace wavecurve::verification
