#include "verification/prints/true_value.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "wavecurve/certified/detail/refine.hpp"
#include "wavecurve/certified/rounding.hpp"

namespace wavecurve::verification {

using certified::Ball;
using certified::Rational;
using certified::WorkingPrecision;

namespace {

constexpr long first_bits = 128;
static_assert(precision_limit_bits == first_bits << certified::precision_doublings);
/// Sums lose a few bits; enclosures stay right whatever this is.
constexpr long guard_bits = 32;

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

}  // namespace wavecurve::verification
