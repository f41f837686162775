#include "verification/routes/tap_rules.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace wavecurve::verification {

using certified::Ball;
using certified::Rational;

namespace {

/// A table of decimals that a column may have been made from.
struct DecimalTaps {
  std::string name;
  std::vector<Rational> numbers;
  Quantity normalization;
  int decimals = 0;  ///< that the true taps were rounded to; 0 for a published table
};

/// What was done to a table: its numbers times the root of a rational number.
struct Scaling {
  std::string words;
  Rational squared_factor;
  double operations = 0;  ///< bound of the relative error in double arithmetic, in units of 2^-53
};

Rational squared_sum(const Quantity& normalization) {
  if (normalization == Quantity::taps_sum_2) return Rational(4);
  if (normalization == Quantity::taps_sum_1) return Rational(1);
  return Rational(2);
}

/// The true taps so rounded; nothing if that is undecided, or changes none of them.
std::optional<DecimalTaps> rounded_taps(const std::vector<TrueValue>& taps,
                                        const Quantity& normalization, int decimals) {
  DecimalTaps table{
      to_string(normalization) + " rounded to " + std::to_string(decimals) + " decimals",
      {},
      normalization,
      decimals};
  bool changed = false;
  for (const TrueValue& tap : taps) {
    const TrueValue scaled = times_root(tap, squared_sum(normalization) / Rational(2));
    const auto rounded = round_to_decimals(scaled, decimals);
    if (!rounded) return std::nullopt;
    table.numbers.push_back(rounded->value());
    const Approximation before = approximate(scaled);
    const Approximation after = approximate({table.numbers.back(), {}});
    changed = changed || apart(before, after) > before.error + after.error;
  }
  return changed ? std::optional(std::move(table)) : std::nullopt;
}

std::vector<DecimalTaps> decimal_taps(const RouteInput& input) {
  std::vector<DecimalTaps> tables;
  if (const auto& published = input.published_taps) {
    tables.push_back(
        {"the taps of " + published->name, published->numbers, published->normalization, 0});
  }
  for (int decimals = most_tap_decimals; decimals >= fewest_tap_decimals; --decimals) {
    for (const Quantity& normalization :
         {Quantity::taps, Quantity::taps_sum_1, Quantity::taps_sum_2}) {
      if (auto table = rounded_taps(input.taps, normalization, decimals)) {
        tables.push_back(*std::move(table));
      }
    }
  }
  return tables;
}

std::vector<Scaling> scalings(const DecimalTaps& table, const Quantity& column, bool orthonormal) {
  Rational sum, absolute, squares;
  for (const Rational& number : table.numbers) {
    sum += number;
    absolute += number.abs();
    squares += number * number;
  }
  const auto terms = static_cast<double>(table.numbers.size());
  const Rational wanted = squared_sum(column);
  std::vector<Scaling> result{{"", wanted / squared_sum(table.normalization), 4}};
  if (!sum.is_zero()) {
    const double cancellation = Ball(absolute / sum.abs()).to_double();
    result.push_back({", divided by their sum", wanted / (sum * sum), terms * cancellation + 6});
  }
  if (orthonormal && !squares.is_zero()) {
    result.push_back({", divided by their norm", wanted / (Rational(2) * squares), terms / 2 + 8});
  }
  return result;
}

Route in_double_arithmetic(Route route, double operations) {
  route.name += ", in double arithmetic";
  route.habits = {route.name};
  const double relative = operations * std::numeric_limits<double>::epsilon() / 2;
  const Eigen::VectorXd bounds = route.doubles.cwiseAbs() * relative;
  route.rounding_errors = [bounds] { return bounds; };
  return route;
}

}  // namespace

std::vector<Route> tap_rules(const Quantity& column, const RouteInput& input) {
  std::vector<Route> exact, computed;
  for (const DecimalTaps& table : decimal_taps(input)) {
    for (const Scaling& scaling : scalings(table, column, input.orthonormal)) {
      std::vector<TrueValue> numbers;
      for (const Rational& number : table.numbers) {
        numbers.push_back(times_root({number, {}}, scaling.squared_factor));
      }
      exact.push_back(rule(table.name + scaling.words, std::move(numbers)));
      if (table.decimals <= most_decimals_in_doubles) {
        computed.push_back(in_double_arithmetic(exact.back(), scaling.operations));
      }
    }
  }
  std::move(computed.begin(), computed.end(), std::back_inserter(exact));
  return exact;
}

}  // namespace wavecurve::verification
