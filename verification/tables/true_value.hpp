#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/certified/rational.hpp"
#include "wavecurve/operators/connection_coefficients.hpp"

#include "verification/tables/published_table.hpp"

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

/// Everything about one filter that a table can list, computed when asked for and then kept.
class FilterValues {
 public:
  explicit FilterValues(certified::FilterDefinition definition);

  const std::string& name() const { return definition_.name; }
  bool is_orthonormal() const { return orthonormal_; }
  int first_tap() const { return first_tap_; }
  int number_of_taps() const { return number_of_taps_; }

  /// Throws std::domain_error if the index is beyond the filter or the integral does not exist.
  /// Taps: the filter's support. alpha: |n| < number of taps. mu, nu: up to the number of taps, or
  /// the first index beyond the support if that is larger (tables print the zero at the end).
  TrueValue value(Quantity quantity, int index);

 private:
  const FilterBank<certified::Ball>& bank(long bits);
  const ConnectionCoefficients<certified::Ball>& coefficients(long bits);
  TrueValue tap(Quantity quantity, int index);
  TrueValue autocorrelation(int index);
  TrueValue coefficient(Quantity quantity, int index);

  certified::FilterDefinition definition_;
  bool orthonormal_ = false;
  int first_tap_ = 0, number_of_taps_ = 0;
  std::map<long, FilterBank<certified::Ball>> banks_;
  std::map<long, ConnectionCoefficients<certified::Ball>> coefficients_;
  std::optional<ConnectionCoefficients<certified::Rational>> exact_coefficients_;
  bool asked_for_exact_ = false;
};

/// The filter that a table's row names: a known name or the path of a user's ".json" file, from the
/// working directory. Throws std::invalid_argument if there is none, or it is not what it claims.
certified::FilterDefinition find_table_filter(const std::string& name);

}  // namespace wavecurve::verification
