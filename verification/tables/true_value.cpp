#include "verification/tables/true_value.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "wavecurve/certified/autocorrelation.hpp"
#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/detail/refine.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/io/load_filter.hpp"

namespace wavecurve::verification {

using certified::Ball;
using certified::Rational;
using certified::WorkingPrecision;

namespace {

constexpr long first_bits = 128;
static_assert(precision_limit_bits == first_bits << certified::precision_doublings);
/// Sums of a filter's products lose a few bits; enclosures stay right whatever this is.
constexpr long guard_bits = 32;

[[noreturn]] void refuse_index(Quantity quantity, int index, const std::string& filter, int first,
                               int last) {
  throw std::domain_error("the index " + std::to_string(index) + " of " +
                          std::string(to_string(quantity)) + " is out of range: " + filter +
                          " has " + std::to_string(first) + " to " + std::to_string(last));
}

bool is_mu(Quantity quantity) {
  return quantity == Quantity::mu || quantity == Quantity::mu_normalized;
}

bool is_normalized(Quantity quantity) {
  return quantity == Quantity::mu_normalized || quantity == Quantity::nu_normalized;
}

template <class Scalar>
Scalar coefficient_of(const ConnectionCoefficients<Scalar>& coefficients, Quantity quantity,
                      int index) {
  const Filter<Scalar>& column = is_mu(quantity) ? coefficients.mu : coefficients.nu;
  return is_normalized(quantity) ? column[index] / column[0] : column[index];
}

/// The rounding that `round` finds in a tight enough enclosure.
template <class Round>
std::optional<PrintedNumber> round_by(const TrueValue& value, Round round) {
  if (value.exact) return parse_printed_number(round(*value.exact));
  std::optional<PrintedNumber> result;
  decide(value, [&](const Ball& enclosure) {
    const std::optional<std::string> text = round(enclosure);
    if (!text) return Decision::undecided;
    result = parse_printed_number(*text);
    return Decision::yes;
  });
  return result;
}

/// The root of the square of a rational number; nothing if it is none.
std::optional<Rational> rational_root(const Rational& square) {
  const fmpz *p = fmpq_numref(square.get()), *q = fmpq_denref(square.get());
  if (fmpz_is_square(p) == 0 || fmpz_is_square(q) == 0) return std::nullopt;
  Rational root;
  fmpz_sqrt(fmpq_numref(root.get()), p);
  fmpz_sqrt(fmpq_denref(root.get()), q);
  return root;
}

}  // namespace

double TrueValue::to_double() const {
  return exact ? Ball(*exact).to_double() : enclosure(first_bits).to_double();
}

Approximation approximate(const TrueValue& value) {
  const WorkingPrecision precision(first_bits + guard_bits);
  const Ball x = value.exact ? Ball(*value.exact) : value.enclosure(first_bits);
  const double head = x.to_double();
  const Ball rest = x - Ball::from_double(head);
  if (x.is_exact() && rest.is_exact() && rest.contains_zero()) return {head, 0, 0};
  // The tail is rounded to 2^-53 of at most 2^-53 of the head, and so is the difference of two.
  constexpr double relative = 0x1p-100;
  return {head, rest.to_double(), x.radius_double() + relative * std::abs(head)};
}

double apart(const Approximation& a, const Approximation& b) {
  return std::abs((a.head - b.head) + (a.tail - b.tail));
}

TrueValue exactly(double number) {
  Rational exact;
  arf_get_fmpq(exact.get(), arb_midref(Ball::from_double(number).get()));
  return {exact, {}};
}

TrueValue times_root(const TrueValue& value, const Rational& square) {
  if (value.is_exactly_zero() || square == Rational(1)) return value;
  const auto root = rational_root(square);
  if (value.exact && root) return {*value.exact * *root, {}};
  return {std::nullopt, [value, square](long bits) {
            const WorkingPrecision precision(bits + guard_bits);
            const Ball x = value.exact ? Ball(*value.exact) : value.enclosure(bits);
            return x * sqrt(Ball(square));
          }};
}

Decision decide(const TrueValue& value, const std::function<Decision(const Ball&)>& ask) {
  Decision answer = Decision::undecided;
  certified::refine(first_bits, [&](long bits) {
    const WorkingPrecision precision(bits + guard_bits);
    answer = ask(value.exact ? Ball(*value.exact) : value.enclosure(bits));
    return answer != Decision::undecided;
  });
  return answer;
}

Decision is_within(const TrueValue& value, const Rational& number, const Rational& radius) {
  if (value.exact) {
    return (*value.exact - number).abs() <= radius ? Decision::yes : Decision::no;
  }
  return decide(value, [&](const Ball& enclosure) {
    const Ball distance = abs(enclosure - Ball(number));
    if (certainly_less(distance, Ball(radius))) return Decision::yes;
    if (certainly_less(Ball(radius), distance)) return Decision::no;
    return Decision::undecided;
  });
}

Decision is_cut_off(const TrueValue& value, const Rational& number, int decimals) {
  const Rational unit = power_of_ten(-decimals), magnitude = number.abs();
  if (value.exact) {
    const bool other_side = number.sign() != 0 && number.sign() != value.exact->sign();
    const Rational rest = value.exact->abs() - magnitude;
    return !other_side && rest.sign() >= 0 && rest < unit ? Decision::yes : Decision::no;
  }
  return decide(value, [&](const Ball& enclosure) {
    // What was left away; of a value that is cut off to zero, all of it.
    const Ball rest = number.sign() < 0   ? -enclosure - Ball(magnitude)
                      : number.sign() > 0 ? enclosure - Ball(magnitude)
                                          : abs(enclosure);
    const bool is_beyond = rest.is_exact() ? !certainly_less(rest, Ball(0)) : rest.is_positive();
    if (is_beyond && certainly_less(rest, Ball(unit))) return Decision::yes;
    const bool is_none = certainly_less(rest, Ball(0)) || certainly_less(Ball(unit), rest);
    if (is_none) return Decision::no;
    return Decision::undecided;
  });
}

std::optional<PrintedNumber> round_to_decimals(const TrueValue& value, int decimals) {
  return round_by(value, [&](const auto& x) { return certified::round_to_decimals(x, decimals); });
}

std::optional<PrintedNumber> round_to_digits(const TrueValue& value, int digits) {
  return round_by(value, [&](const auto& x) { return certified::round_to_digits(x, digits); });
}

FilterValues::FilterValues(certified::FilterDefinition definition)
    : definition_(std::move(definition)) {
  const FilterBank<Ball>& known = bank(first_bits);
  orthonormal_ = known.is_orthonormal();
  first_tap_ = known.synthesis_low.first_index;
  number_of_taps_ = known.synthesis_low.size();
}

const FilterBank<Ball>& FilterValues::bank(long bits) {
  const auto known = banks_.find(bits);
  if (known != banks_.end()) return known->second;
  const WorkingPrecision precision(bits + guard_bits);
  return banks_.emplace(bits, definition_.bank(bits)).first->second;
}

const ConnectionCoefficients<Ball>& FilterValues::coefficients(long bits) {
  const auto known = coefficients_.find(bits);
  if (known != coefficients_.end()) return known->second;
  const WorkingPrecision precision(bits + guard_bits);
  return coefficients_.emplace(bits, certified::connection_coefficients(definition_, 1, 1, bits))
      .first->second;
}

TrueValue FilterValues::tap(Quantity quantity, int index) {
  const int last = first_tap_ + number_of_taps_ - 1;
  if (index < first_tap_ || index > last) {
    refuse_index(quantity, index, definition_.name, first_tap_, last);
  }
  return {std::nullopt, [this, quantity, index](long bits) {
            const Ball h = bank(bits).synthesis_low[index];
            const WorkingPrecision precision(bits + guard_bits);
            if (quantity == Quantity::taps_sum_2) return h * sqrt(Ball(2));
            if (quantity == Quantity::taps_sum_1) return h / sqrt(Ball(2));
            return h;
          }};
}

TrueValue FilterValues::autocorrelation(int index) {
  const int n = std::abs(index);
  if (n >= number_of_taps_) {
    refuse_index(Quantity::autocorrelation, index, definition_.name, 1 - number_of_taps_,
                 number_of_taps_ - 1);
  }
  // Orthonormality makes the even ones exact, whatever the taps.
  if (orthonormal_ && n % 2 == 0) return {Rational(n == 0 ? 2 : 0), {}};
  if (definition_.exact) return {definition_.exact->synthesis[n], {}};
  return {std::nullopt, [this, n](long bits) {
            const WorkingPrecision precision(bits + guard_bits);
            return certified::autocorrelation(definition_, bits)[n];
          }};
}

TrueValue FilterValues::coefficient(Quantity quantity, int index) {
  if (!asked_for_exact_) {
    exact_coefficients_ = certified::exact_connection_coefficients(definition_, 1, 1);
    asked_for_exact_ = true;
  }
  const auto last_index = [&](const auto& known) {
    return is_mu(quantity) ? known.mu.last_index() : known.nu.last_index();
  };
  const int last =
      std::max(number_of_taps_, 1 + (exact_coefficients_ ? last_index(*exact_coefficients_)
                                                         : last_index(coefficients(first_bits))));
  if (index < -last || index > last) refuse_index(quantity, index, definition_.name, -last, last);
  if (exact_coefficients_) return {coefficient_of(*exact_coefficients_, quantity, index), {}};
  const bool outside = std::abs(index) > last_index(coefficients(first_bits));
  if (outside) return {Rational(0), {}};
  if (index == 0 && is_normalized(quantity)) return {Rational(1), {}};
  return {std::nullopt, [this, quantity, index](long bits) {
            const ConnectionCoefficients<Ball>& known = coefficients(bits);
            const WorkingPrecision precision(bits + guard_bits);
            return coefficient_of(known, quantity, index);
          }};
}

TrueValue FilterValues::value(Quantity quantity, int index) {
  if (is_taps(quantity)) return tap(quantity, index);
  if (quantity == Quantity::autocorrelation) return autocorrelation(index);
  return coefficient(quantity, index);
}

certified::FilterDefinition find_table_filter(const std::string& name) {
  return io::load_filter(name);
}

}  // namespace wavecurve::verification
