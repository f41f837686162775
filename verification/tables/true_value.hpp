#pragma once

#include <functional>
#include <optional>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/rational.hpp"

#include "verification/tables/printed_number.hpp"

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

enum class Decision { no, yes, undecided };

/// Asks with ever tighter enclosures, from 128 bits to precision_limit_bits, until the answer is
/// there (certified/refine.hpp).
Decision decide(const TrueValue& value, const std::function<Decision(const certified::Ball&)>& ask);

/// Is |value - number| <= radius? Proved.
Decision is_within(const TrueValue& value, const certified::Rational& number,
                   const certified::Rational& radius);

/// The value correctly rounded to this many decimals, or to this many significant digits; nothing
/// if undecided at the limit.
std::optional<PrintedNumber> round_to_decimals(const TrueValue& value, int decimals);
std::optional<PrintedNumber> round_to_digits(const TrueValue& value, int digits);

}  // namespace wavecurve::verification
