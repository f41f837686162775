#include "tools/commands/output/study_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "wavecurve/filters/detail/characters.hpp"

#include "reports/study_overview.hpp"

namespace wavecurve::tools {

namespace {

using namespace verification;

std::string tolerance_text(const std::optional<double>& tolerance) {
  return tolerance ? fmt::format("{:.3g}", *tolerance) : "-";
}

std::string interval_text(const PowerFit& fit) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", fit.exponent, fit.low, fit.high);
}

std::string point_text(const StudyPoint& point) {
  std::string text = fmt::format("{:<24}  {:>9}  ", point.solver, tolerance_text(point.tolerance));
  if (!point.errors) return text + "failed: " + printable(point.failure) + "\n";
  const StudyErrors& e = *point.errors;
  for (const double error : {e.displacement_l2_max, e.displacement_l2_final, e.maximum_norm_max,
                             e.velocity_l2_max, e.energy_norm_max, e.energy_drift}) {
    text += fmt::format("{:>8.1e}  ", error);
  }
  return text + fmt::format("{:>8}  {:>8.2g}  {:>8.1e}\n", point.cost.evaluations,
                            static_cast<double>(point.cost.operations), point.seconds);
}

std::string setting_text(const StudySetting& setting, const std::vector<StudyPoint>& points,
                         const StudySummary& summary) {
  std::string text =
      printable(name_of(setting)) +
      fmt::format(
          "\n{:<24}  {:>9}  {:>8}  {:>8}  {:>8}  {:>8}  {:>8}  {:>8}  {:>8}  {:>8}  {:>8}\n",
          "solver", "tolerance", "L2 max", "L2 final", "maximum", "velocity", "energy", "drift",
          "evals", "operat.", "seconds");
  for (const StudyPoint& point : points) {
    if (*point.setting == setting) text += point_text(point);
  }
  for (const ErrorFloor& floor : summary.floors) {
    if (*floor.setting != setting) continue;
    text +=
        fmt::format("{}: floor {:.3g}, its model error\n", floor.solver, floor.displacement_l2_max);
  }
  for (const ObservedOrder& order : summary.orders) {
    if (*order.setting != setting) continue;
    text += fmt::format("{}: observed order {}, {} points, {:.3g} to {:.3g}\n", order.solver,
                        interval_text(order.fit), order.fit.points, order.tolerances.front(),
                        order.tolerances.back());
  }
  return text;
}

/// Its title, then its columns, each as wide as it needs; nothing if it has no rows.
std::string table_text(const Table& table) {
  if (table.rows.empty()) return "";
  std::vector<std::size_t> widths(table.columns.size());
  const auto widen = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  };
  widen(table.columns);
  for (const auto& row : table.rows) widen(row);
  const auto line = [&](const std::vector<std::string>& row) {
    std::string text;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      text += fmt::format("{:<{}}  ", printable(row[i]), widths[i]);
    }
    return text + printable(row.back()) + "\n";
  };
  std::string text = "\n" + table.caption + "\n" + line(table.columns);
  for (const auto& row : table.rows) text += line(row);
  return text;
}

}  // namespace

std::string study_text(const std::vector<StudyPoint>& points, const StudySummary& summary) {
  std::string text =
      "rest shape the unit circle, released at rest, t from 0 to 1; errors against the exact "
      "motion,\nrelative to the initial state; of a closed form (no tolerance) they are those of "
      "its model,\nwhich no tolerance makes smaller; seconds of one thread's processor time, least "
      "of up to 5 runs\n";
  const std::vector<StudySetting> settings = settings_of(points);
  if (settings.size() > reports::most_settings_shown) {
    text += fmt::format("\n{} points of {} settings\n", points.size(), settings.size());
    for (const Table& table :
         {reports::accuracy_map(points).data, reports::extremes_table(points, summary),
          reports::orders_overview(summary), reports::growth_overview(summary)}) {
      text += table_text(table);
    }
    return text;
  }
  for (const StudySetting& setting : settings) {
    text += "\n" + setting_text(setting, points, summary);
  }
  for (const Growth& growth : summary.growth) {
    text +=
        fmt::format("{} at {}, N = {} to {}: operations N^{}, seconds N^{}\n", growth.solver,
                    tolerance_text(growth.tolerance), growth.samples.front(), growth.samples.back(),
                    interval_text(growth.operations), interval_text(growth.seconds));
  }
  return text;
}

}  // namespace wavecurve::tools
