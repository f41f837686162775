#include "verification/tables/true_value.hpp"

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

}  // namespace

double TrueValue::to_double() const {
  return exact ? Ball(*exact).to_double() : enclosure(first_bits).to_double();
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

std::optional<PrintedNumber> round_to_decimals(const TrueValue& value, int decimals) {
  return round_by(value, [&](const auto& x) { return certified::round_to_decimals(x, decimals); });
}

std::optional<PrintedNumber> round_to_digits(const TrueValue& value, int digits) {
  return round_by(value, [&](const auto& x) { return certified::round_to_digits(x, digits); });
}

}  // namespace wavecurve::verification
