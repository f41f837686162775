#include "verification/routes/column_routes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wavecurve/elementary/root.hpp"

#include "verification/prints/print_form.hpp"
#include "verification/routes/route_chance.hpp"

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
        approximate_unit(1 / whole_power(10, number.decimals())) {}

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

/// Proved, by approximations with their error bounds or, where these do not decide, by enclosures.
bool yields(const Route& route, std::size_t place, const Target& target, double allowance) {
  const Approximation computed = route.approximation(place);
  const double difference = apart(computed, target.approximation);
  const bool is_cut_off_print = route.printing == Printing::cut_off;
  const double reach = (is_cut_off_print ? 1 : 0.5 + allowance) * target.approximate_unit;
  // The reach is a product of rounded numbers; this is far more than it is off.
  constexpr double margin = 1e-12;
  const double uncertain = computed.error + target.approximation.error + margin * reach;
  if (difference > reach + uncertain) return false;
  if (is_cut_off_print) {
    return is_cut_off(route.value(place), target.value, target.print.decimals()) == Decision::yes;
  }
  if (difference < reach - uncertain) return true;
  const Rational exact_reach = (Rational(1, 2) + *exactly(allowance).exact) * target.unit;
  return is_within(route.value(place), target.value, exact_reach) == Decision::yes;
}

double distance(const Route& route, std::size_t place, const Target& target) {
  const Approximation computed = route.approximation(place);
  const double difference = apart(computed, target.approximation);
  constexpr double shown = 1e-3;  // of a distance, or of a unit
  const double uncertain = computed.error + target.approximation.error;
  const bool is_sure = uncertain <= shown * std::max(difference, target.approximate_unit);
  return is_sure ? difference / target.approximate_unit
                 : distance_in_units(route.value(place), target.print);
}

/// All but one in eight.
bool is_nearly_all(int yielded, std::size_t of) {
  constexpr int one_in = 8;
  const int entries = static_cast<int>(of);
  return (entries - yielded) * one_in <= entries;
}

void count(RouteScore& score, const EntryToExplain& entry, bool direct, bool edited,
           double distance) {
  score.yields_print.push_back(direct);
  score.yields.push_back(direct || edited);
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
  RouteScore result{route.name, route.habits, 0, 0, 0, 0, 0, 1, 1, {}, {}};
  std::vector<EntryError> errors;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const auto& [entry, print, repaired] = targets[i];
    const bool direct = yields(route, entry.place, print, allowances[i]);
    const bool edited = !direct && repaired && yields(route, entry.place, *repaired, 0);
    count(result, entry, direct, edited, distance(route, entry.place, edited ? *repaired : print));
    result.allowance = std::max(result.allowance, allowances[i]);
    // What is yielded but for an edit is no evidence for the computation.
    errors.push_back({edited ? 0 : entry.distance, print.approximate_unit, allowances[i],
                      std::abs(print.approximation.head)});
  }
  if (result.explains()) {
    result.chance = chance_of_at_least(result.matched, chance_of_each(errors));
  }
  return result;
}

/// How many entries a floating-point computation can yield with the largest allowance there is.
int within_reach(const std::vector<EntryTarget>& targets, const Route& route) {
  constexpr double any = std::numeric_limits<double>::infinity();
  return static_cast<int>(
      std::count_if(targets.begin(), targets.end(), [&](const EntryTarget& target) {
        return target.repaired ||
               yields(route, target.entry.place, target.print, allowance_for(target, any));
      }));
}

RouteScore score(const std::vector<EntryTarget>& targets, const Route& route) {
  RouteScore as_it_is = score(targets, route, std::vector<double>(targets.size(), 0));
  if (!route.rounding_errors) return as_it_is;
  as_it_is.trials = 2;
  // The bounds are computed only where some bound would do.
  const int reachable = within_reach(targets, route);
  if (reachable <= as_it_is.matched || !is_nearly_all(reachable, targets.size())) return as_it_is;
  const Eigen::VectorXd errors = route.rounding_errors();
  std::vector<double> allowances;
  for (const EntryTarget& target : targets) {
    const auto place = static_cast<Eigen::Index>(target.entry.place);
    allowances.push_back(allowance_for(target, place < errors.size() ? errors[place] : 0));
  }
  RouteScore allowed = score(targets, route, allowances);
  allowed.trials = 2;
  return allowed.explains() && allowed.matched > as_it_is.matched ? allowed : as_it_is;
}

}  // namespace

bool RouteScore::explains() const { return is_nearly_all(matched, yields_print.size()); }

RouteScore score_of_true_values(const std::vector<EntryToExplain>& entries) {
  RouteScore score{"the true values, correctly rounded", {}, 0, 0, 0, 0, 0, 0, 1, {}, {}};
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
