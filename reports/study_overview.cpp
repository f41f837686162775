#include "reports/study_overview.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/study_charts.hpp"

namespace wavecurve::reports {

namespace {

using namespace verification;

std::string three_digits(double value) { return fmt::format("{:.3g}", value); }

/// Some numbers, and where the largest stands.
struct Spread {
  std::vector<double> values;
  std::size_t failed = 0;
  double largest = -INFINITY;
  const StudySetting* where = nullptr;

  void add(double value, const StudySetting& setting) {
    values.push_back(value);
    if (value > largest) where = &setting;
    largest = std::max(largest, value);
  }

  /// The smallest, the median and the largest.
  std::vector<std::string> texts() const {
    if (values.empty()) return {"-", "-", "-"};
    std::vector<double> sorted = values;
    std::ranges::sort(sorted);
    return {three_digits(sorted.front()), three_digits(sorted[sorted.size() / 2]),
            three_digits(sorted.back())};
  }
};

/// Spreads by a key, in the order of the first of each.
template <class Key>
class Spreads {
 public:
  Spread& operator[](const Key& key) {
    const auto [found, is_new] = place_.emplace(key, spreads_.size());
    if (is_new) spreads_.emplace_back(key, Spread());
    return spreads_[found->second].second;
  }
  const std::vector<std::pair<Key, Spread>>& all() const { return spreads_; }

 private:
  std::map<Key, std::size_t> place_;
  std::vector<std::pair<Key, Spread>> spreads_;
};

/// What settings may differ in: its name, and its value in one.
std::vector<std::pair<std::string, std::string>> values_of(const StudySetting& setting) {
  return {{"filter", setting.filter},
          {"samples", std::to_string(setting.samples)},
          {"levels", std::to_string(setting.levels)},
          {"shape", setting.shape},
          {"s_1", fmt::format("{}", setting.mass_damping)},
          {"s_2", fmt::format("{}", setting.stiffness_damping)}};
}

template <class T>
Table exponents(const std::string& title, const std::vector<T>& items, PowerFit T::*fit) {
  Spreads<std::string> spreads;
  for (const T& item : items) spreads[item.solver].add((item.*fit).exponent, *item.setting);
  Table table{title, {"solver", "fits", "smallest", "median", "largest"}, {}};
  for (const auto& [solver, spread] : spreads.all()) {
    std::vector<std::string> row = {solver, std::to_string(spread.values.size())};
    for (const std::string& text : spread.texts()) row.push_back(text);
    table.rows.push_back(row);
  }
  return table;
}

/// A square for each accuracy of each solver, lighter where the worst error is smaller, with that
/// error's power of ten.
std::string map_script(const std::vector<std::string>& solvers) {
  std::vector<std::string> tics, squares, labels;
  for (std::size_t i = 0; i < solvers.size(); ++i) {
    tics.push_back(fmt::format("\"{}\" {}", solvers[i], i + 1));
    const std::string y = fmt::format("(stringcolumn(1) eq '{}' ? {} : NaN)", solvers[i], i + 1);
    squares.push_back("data using 2:" + y +
                      ":(log10($8)) with points pointtype 5 pointsize 4 palette");
    labels.push_back(
        "data using 2:" + y +
        ":(sprintf('%d', floor(log10($8) + 0.5))) with labels font \",11\" textcolor rgb \"#000000\"");
  }
  return fmt::format(
      "unset key\nset palette defined (0 \"#f4f4f4\", 1 \"#a8a8a8\")\n"
      "set cblabel \"largest error, power of ten\"\nset xlabel \"accuracy, from coarse to fine\"\n"
      "set xrange [0.5:10.5]\nset xtics 1\nset yrange [0.5:{}]\nset ytics ({})\nset border 3\n"
      "plot {}, \\\n  {}\n",
      static_cast<double>(solvers.size()) + 0.5, fmt::join(tics, ", "),
      fmt::join(squares, ", \\\n  "), fmt::join(labels, ", \\\n  "));
}

}  // namespace

Chart accuracy_map(const std::vector<StudyPoint>& points) {
  using Key = std::pair<std::string, double>;
  Spreads<Key> spreads;
  for (const StudyPoint& point : points) {
    if (!point.tolerance) continue;
    Spread& spread = spreads[{point.solver, *point.tolerance}];
    if (point.errors) {
      spread.add(point.errors->displacement_l2_max, *point.setting);
    } else {
      ++spread.failed;
    }
  }
  Chart chart;
  chart.id = "accuracy-map";
  chart.data = {
      "The solvers with steps over all settings: the largest L2 error of the displacement, of the "
      "initial one, at each accuracy",
      {"solver", "accuracy", "tolerance or step", "solved", "failed", "smallest", "median",
       "largest", "largest in"},
      {}};
  std::vector<std::string> solvers;
  std::size_t number = 0;
  for (const auto& [key, spread] : spreads.all()) {
    const bool is_new = solvers.empty() || solvers.back() != key.first;
    if (is_new) solvers.push_back(key.first);
    number = is_new ? 1 : number + 1;
    std::vector<std::string> row = {key.first, std::to_string(number), three_digits(key.second),
                                    std::to_string(spread.values.size()),
                                    std::to_string(spread.failed)};
    for (const std::string& text : spread.texts()) row.push_back(text);
    row.push_back(spread.where ? name_of(*spread.where) : "-");
    chart.data.rows.push_back(row);
  }
  const bool any =
      std::ranges::any_of(spreads.all(), [](const auto& one) { return one.second.largest > 0; });
  if (any) chart.script = map_script(solvers);
  return chart;
}

Table extremes_table(const std::vector<StudyPoint>& points, const StudySummary& summary) {
  constexpr std::size_t shown = 10;
  const ShortNames short_name(settings_of(points));
  std::map<std::string, std::vector<const ErrorFloor*>> floors;
  for (const ErrorFloor& floor : summary.floors) floors[floor.solver].push_back(&floor);
  Table table{
      "Where each model errs most and least: its largest L2 error relative to the initial displacement",
      {"model", "", "error", "setting"},
      {}};
  for (auto& [model, all] : floors) {
    std::ranges::stable_sort(all, std::ranges::greater(), &ErrorFloor::displacement_l2_max);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool is_worst = i < shown;
      if (!is_worst && i + shown < all.size()) continue;
      table.rows.push_back({model, is_worst ? "worst" : "best",
                            three_digits(all[i]->displacement_l2_max),
                            short_name(*all[i]->setting)});
    }
  }
  return table;
}

Table influence_table(const StudySummary& summary) {
  using Key = std::pair<std::pair<std::string, std::string>, std::string>;
  Spreads<Key> spreads;
  std::map<std::string, std::map<std::string, bool>> values;
  for (const ErrorFloor& floor : summary.floors) {
    for (const auto& value : values_of(*floor.setting)) {
      values[value.first][value.second] = true;
      spreads[{value, floor.solver}].add(floor.displacement_l2_max, *floor.setting);
    }
  }
  Table table{"What the error of the models depends on: its spread over all settings of that value",
              {"", "value", "model", "settings", "smallest", "median", "largest"},
              {}};
  for (const auto& [key, spread] : spreads.all()) {
    const auto& [name, value] = key.first;
    if (values[name].size() < 2) continue;
    std::vector<std::string> row = {name, value, key.second, std::to_string(spread.values.size())};
    for (const std::string& text : spread.texts()) row.push_back(text);
    table.rows.push_back(row);
  }
  std::ranges::stable_sort(table.rows, {},
                           [](const auto& row) { return std::pair(row[0], row[2]); });
  return table;
}

Table orders_overview(const StudySummary& summary) {
  return exponents(
      "Observed orders over all settings: the error falls as the evaluations to this power",
      summary.orders, &ObservedOrder::fit);
}

Table growth_overview(const StudySummary& summary) {
  return exponents("Growth of the operations with the number of samples, as a power of it",
                   summary.growth, &Growth::operations);
}

}  // namespace wavecurve::reports
