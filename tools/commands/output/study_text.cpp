#include "tools/commands/output/study_text.hpp"

#include <fmt/format.h>

#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/io/files/detail/csv.hpp"

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
    if (point.setting == setting) text += point_text(point);
  }
  for (const ErrorFloor& floor : summary.floors) {
    if (!(floor.setting == setting)) continue;
    text +=
        fmt::format("{}: floor {:.3g}, its model error\n", floor.solver, floor.displacement_l2_max);
  }
  for (const ObservedOrder& order : summary.orders) {
    if (!(order.setting == setting)) continue;
    text += fmt::format("{}: observed order {}, {} points, {:.3g} to {:.3g}\n", order.solver,
                        interval_text(order.fit), order.fit.points, order.tolerances.front(),
                        order.tolerances.back());
  }
  return text;
}

}  // namespace

std::string study_text(const std::vector<StudyPoint>& points, const StudySummary& summary) {
  std::string text =
      "rest shape the unit circle, released at rest, t from 0 to 1; errors against the exact "
      "motion,\nrelative to the initial state; of a closed form (no tolerance) they are those of "
      "its model,\nwhich no tolerance makes smaller; seconds of one thread's processor time, least "
      "of up to 5 runs\n";
  for (const StudySetting& setting : settings_of(points)) {
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

std::string study_csv(const std::vector<StudyPoint>& points) {
  std::string text =
      "solver,filter,samples,levels,shape,s1,s2,tolerance,displacement_l2_max,"
      "displacement_l2_final,maximum_norm_max,maximum_norm_final,velocity_l2_max,"
      "velocity_l2_final,energy_norm_max,energy_norm_final,energy_drift,evaluations,operations,"
      "seconds,status\n";
  for (const StudyPoint& point : points) {
    const StudySetting& s = point.setting;
    text +=
        fmt::format("{},{},{},{},{},{},{},{},", point.solver, io::csv_field(s.filter), s.samples,
                    s.levels, io::csv_field(s.shape), s.mass_damping, s.stiffness_damping,
                    point.tolerance ? fmt::format("{}", *point.tolerance) : "");
    if (const auto& e = point.errors) {
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},ok\n", e->displacement_l2_max,
                          e->displacement_l2_final, e->maximum_norm_max, e->maximum_norm_final,
                          e->velocity_l2_max, e->velocity_l2_final, e->energy_norm_max,
                          e->energy_norm_final, e->energy_drift, point.cost.evaluations,
                          point.cost.operations, point.seconds);
    } else {
      text += ",,,,,,,,,,,,failed\n";
    }
  }
  return text;
}

}  // namespace wavecurve::tools
