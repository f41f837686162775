#pragma once

#include <optional>
#include <string>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/rational.hpp"

namespace wavecurve::certified {

/// A number as text, with its proof.
struct DecimalEnclosure {
  std::string value;                 ///< a decimal, correctly rounded to the digits asked for
  std::string radius;                ///< an upper bound of |true value - value|, such as "5e-41"
  std::optional<std::string> exact;  ///< the fraction, where the number is rational
};

DecimalEnclosure decimal_enclosure(const Rational& x, int digits);

/// Empty if the enclosure does not decide the rounding and is not exactly zero.
std::optional<DecimalEnclosure> decimal_enclosure(const Ball& x, int digits);

/// The midpoint with the digits that the radius supports (at most `digits`), for enclosures that no
/// precision makes narrower, as those of a user's own decimals.
DecimalEnclosure supported_decimal(const Ball& x, int digits);

}  // namespace wavecurve::certified
