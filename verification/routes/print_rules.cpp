#include "verification/routes/print_rules.hpp"

#include <optional>
#include <utility>

#include "wavecurve/certified/rounding.hpp"

namespace wavecurve::verification {

using certified::Ball;

namespace {

/// What `round` makes of every value: the nearest double, the nearest float. Nothing if one is open
/// at the precision limit.
template <class Round>
std::optional<std::vector<TrueValue>> nearest(const std::vector<TrueValue>& values, Round round) {
  std::vector<TrueValue> result;
  for (const TrueValue& value : values) {
    std::optional<double> number;
    decide(value, [&](const Ball& enclosure) {
      number = round(enclosure);
      return number ? Decision::yes : Decision::undecided;
    });
    if (!number) return std::nullopt;
    result.push_back(exactly(*number));
  }
  return result;
}

}  // namespace

std::vector<Route> print_rules(const std::vector<TrueValue>& values) {
  std::vector<Route> rules{
      rule("the true values, cut off instead of rounded", values, Printing::cut_off)};
  if (auto doubles = nearest(values, [](const Ball& x) { return certified::round_to_double(x); })) {
    rules.push_back(rule("the nearest doubles", *std::move(doubles)));
  }
  const auto to_float = [](const Ball& x) -> std::optional<double> {
    const auto rounded = certified::round_to_float(x);
    return rounded ? std::optional<double>(*rounded) : std::nullopt;
  };
  if (auto floats = nearest(values, to_float)) {
    rules.push_back(rule("the nearest single-precision numbers", *std::move(floats)));
  }
  return rules;
}

}  // namespace wavecurve::verification
