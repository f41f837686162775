#include "verification/tables/column_routes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/tables/print_form.hpp"
#include "verification/tables/route_chance.hpp"

namespace wavecurve::verification {

using certified::Rational;

namespace {

/// A print with what is asked of it again and again.
struct Target {
  explicit Target(const PrintedNumber& number)
      : print(number),
        value(number.value()),
        unit(number.unit()),
        approximation(approximate({value, {}})),
        approximate_unit(std::pow(10.0, -number.decimals())) {}

  PrintedNumber print;
  Rational value, unit;
  Approximation approximation;
  double approximate_unit;
};

struct EntryTarget {
  EntryToExplain entry;
  Target print;
  std::optional<Target> repaired;
};

std::vector<EntryTarget> targets_of(const std::vector<EntryToExplain>& entries) {
  std::vector<EntryTarget> targets;
  for (const EntryToExplain& entry : entries) {
    targets.push_back({entry, Target(entry.print), std::nullopt});
    if (entry.repaired) targets.back().repaired.emplace(*entry.repaired);
  }
  return targets;
}

/// Proved, unless the approximations are so far apart already that there is nothing to prove.
bool yields(const Route& route, std::size_t place, const Target& target, double allowance) {
  const Approximation computed = route.approximation(place);
  if (apart(computed, target.approximation) >
      (1 + allowance) * target.approximate_unit + computed.error + target.approximation.error) {
    return false;
  }
  if (route.printing == Printing::cut_off) {
    return is_cut_off(route.value(place), target.value, target.print.decimals()) == Decision::yes;
  }
  const Rational reach = (Rational(1, 2) + *exactly(allowance).exact) * target.unit;
  return is_within(route.value(place), target.value, reach) == Decision::yes;
}

double distance(const Route& route, std::size_t place, const Target& target) {
  const Approximation computed = route.approximation(place);
  const double difference = apart(computed, target.approximation);
  constexpr double digits_shown = 1e3;
  const bool is_sure = difference > digits_shown * (computed.error + target.approximation.error);
  return is_sure ? difference / target.approximate_unit
                 : distance_in_units(route.value(place), target.print);
}

void count(RouteScore& score, const EntryToExplain& entry, bool direct, bool edited,
           double distance) {
  score.yields_print.push_back(direct);
  score.matched += direct || edited ? 1 : 0;
  score.after_edit += edited && !direct ? 1 : 0;
  score.own += direct && entry.wrong ? 1 : 0;
  score.farthest = std::max(score.farthest, distance);
}

/// Half the distance to the true value at most: more would make the print the true value's.
double allowance_for(const EntryTarget& target, double rounding_error) {
  return std::min(rounding_error / target.print.approximate_unit, target.entry.distance / 2);
}

/// How the route does with so much allowance for each entry, in last units.
RouteScore score(const std::vector<EntryTarget>& targets, const Route& route,
                 const std::vector<double>& allowances) {
  RouteScore result{route.name, route.habits, 0, 0, 0, 0, 0, 1, 1, {}};
  std::vector<EntryError> errors;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const auto& [entry, print, repaired] = targets[i];
    const bool direct = yields(route, entry.place, print, allowances[i]);
    const bool edited = !direct && repaired && yields(route, entry.place, *repaired, 0);
    count(result, entry, direct, edited, distance(route, entry.place, edited ? *repaired : print));
    result.allowance = std::max(result.allowance, allowances[i]);
    // A misprint is no evidence for a computation.
    errors.push_back({repaired ? 0 : entry.distance, print.approximate_unit, allowances[i]});
  }
  if (result.explains()) {
    result.chance = chance_of_at_least(result.matched, chance_of_each(errors));
  }
  return result;
}

RouteScore score(const std::vector<EntryTarget>& targets, const Route& route) {
  RouteScore as_it_is = score(targets, route, std::vector<double>(targets.size(), 0));
  if (!route.rounding_errors) return as_it_is;
  as_it_is.trials = 2;
  const auto allowed = [&](const auto& error_of) {
    std::vector<double> allowances;
    for (const EntryTarget& target : targets) {
      allowances.push_back(allowance_for(target, error_of(target.entry.place)));
    }
    RouteScore result = score(targets, route, allowances);
    result.trials = 2;
    return result;
  };
  const auto is_better = [&](const RouteScore& other) {
    return other.explains() && other.matched > as_it_is.matched;
  };
  // The bounds are computed only where some bound would do.
  const double any = std::numeric_limits<double>::infinity();
  if (!is_better(allowed([any](std::size_t) { return any; }))) return as_it_is;
  const Eigen::VectorXd errors = route.rounding_errors();
  RouteScore result = allowed([&](std::size_t place) {
    return place < static_cast<std::size_t>(errors.size())
               ? errors[static_cast<Eigen::Index>(place)]
               : 0.0;
  });
  return is_better(result) ? result : as_it_is;
}

}  // namespace

bool RouteScore::explains() const {
  constexpr int one_in = 8;
  const int of = static_cast<int>(yields_print.size());
  return (of - matched) * one_in <= of;
}

RouteScore score_of_true_values(const std::vector<EntryToExplain>& entries) {
  RouteScore score{"the true values, correctly rounded", {}, 0, 0, 0, 0, 0, 0, 1, {}};
  for (const EntryToExplain& entry : entries) {
    count(score, entry, !entry.wrong, entry.repaired.has_value(),
          entry.repaired ? 0.0 : entry.distance);
  }
  return score;
}

std::vector<RouteScore> score_routes(const std::vector<EntryToExplain>& entries,
                                     const std::vector<Route>& routes) {
  const std::vector<EntryTarget> targets = targets_of(entries);
  std::vector<RouteScore> scores{score_of_true_values(entries)};
  for (const Route& route : routes) scores.push_back(score(targets, route));
  return scores;
}

}  // namespace wavecurve::verification
