#include "verification/tables/column_routes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace wavecurve::verification {

namespace {

/// Distance from the print in units of its last digit, or of the column's where that is coarser
/// (a zero printed with 37 decimals is no claim to them).
double distance_in_units(double computed, const PrintedNumber& print, const PrintForm& column) {
  const int decimals =
      column.scientific ? print.decimals() : std::min(print.decimals(), column.digits);
  return std::abs(computed - print.to_double()) * std::pow(10.0, decimals);
}

/// Half a unit, and some units of the last binary place: routes are computed in double precision.
bool yields(double computed, const PrintedNumber& print, const PrintForm& column) {
  constexpr double few = 8;
  const double slack = few * std::numeric_limits<double>::epsilon() *
                       std::max(1.0, std::abs(computed)) * std::pow(10.0, print.decimals());
  return distance_in_units(computed, print, column) <= 0.5 + slack;
}

void count(RouteScore& score, const EntryToExplain& entry, double computed,
           const PrintForm& column) {
  const bool direct = yields(computed, entry.print, column);
  const bool edited = !direct && entry.repaired && yields(computed, *entry.repaired, column);
  score.yields_print.push_back(direct);
  score.matched += direct || edited ? 1 : 0;
  score.after_edit += edited ? 1 : 0;
  score.own += direct && entry.wrong ? 1 : 0;
  double distance = distance_in_units(computed, entry.print, column);
  if (entry.repaired) {
    distance = std::min(distance, distance_in_units(computed, *entry.repaired, column));
  }
  score.farthest = std::max(score.farthest, distance);
}

/// What is proved; the doubles only measure the distance.
RouteScore score_of_true_values(const ColumnToExplain& column) {
  RouteScore score{"the true values, correctly rounded", 0, 0, 0, 0, {}};
  for (const EntryToExplain& entry : column.entries) {
    count(score, entry, entry.true_value, column.form);
    score.yields_print.back() = !entry.wrong;
  }
  score.own = 0;
  score.after_edit = static_cast<int>(
      std::count_if(column.entries.begin(), column.entries.end(),
                    [](const EntryToExplain& entry) { return entry.wrong && entry.repaired; }));
  score.matched = score.after_edit + static_cast<int>(std::count_if(
                                         column.entries.begin(), column.entries.end(),
                                         [](const EntryToExplain& entry) { return !entry.wrong; }));
  return score;
}

RouteScore score_of_cut_off_values(const ColumnToExplain& column) {
  RouteScore score{"the true values, cut off instead of rounded", 0, 0, 0, 0, {}};
  for (const EntryToExplain& entry : column.entries) {
    const double scale = std::pow(10.0, entry.print.decimals());
    count(score, entry, std::trunc(entry.true_value * scale) / scale, column.form);
  }
  return score;
}

}  // namespace

std::vector<RouteScore> score_routes(const ColumnToExplain& column, const RouteInput& input) {
  std::vector<RouteScore> scores{score_of_true_values(column)};
  const bool all_right = std::none_of(column.entries.begin(), column.entries.end(),
                                      [](const EntryToExplain& entry) { return entry.wrong; });
  if (all_right) return scores;
  scores.push_back(score_of_cut_off_values(column));
  for (const RouteValues& route : run_routes(column.quantity, input)) {
    RouteScore score{route.name, 0, 0, 0, 0, {}};
    const auto size = static_cast<std::size_t>(route.values.size());
    for (const EntryToExplain& entry : column.entries) {
      const double computed =
          entry.place < size ? route.values[static_cast<Eigen::Index>(entry.place)] : 0.0;
      count(score, entry, computed, column.form);
    }
    scores.push_back(std::move(score));
  }
  return scores;
}

const RouteScore& best_route(const std::vector<RouteScore>& scores) {
  if (scores.empty()) throw std::invalid_argument("there is no route to choose from");
  const RouteScore* best = &scores.front();
  for (const RouteScore& score : scores) {
    if (score.own >= least_entries_of_a_route && score.matched > best->matched) best = &score;
  }
  return *best;
}

}  // namespace wavecurve::verification
