#include "reports/study_charts.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/filters/detail/characters.hpp"

#include "verification/study/study_plan.hpp"

namespace wavecurve::reports {

namespace {

using namespace verification;
using Names = std::vector<std::string>;

/// Beyond the five line types of all charts, for as many solvers as there are.
constexpr const char* more_lines =
    "set linetype 6 linecolor rgb \"#8a6d00\" linewidth 2 dashtype 1 pointtype 6 pointsize 0.7\n"
    "set linetype 7 linecolor rgb \"#a0305f\" linewidth 2 dashtype 2 pointtype 8 pointsize 0.8\n"
    "set linetype 8 linecolor rgb \"#2f7f8f\" linewidth 2 dashtype 4 pointtype 12 pointsize 0.8\n"
    "set linetype 9 linecolor rgb \"#777777\" linewidth 2 dashtype 3 pointtype 2 pointsize 0.7\n";

std::string number(double value) { return fmt::format("{:.3g}", value); }

std::string number(const std::optional<double>& value) { return value ? number(*value) : "-"; }

bool is_model(const StudyPoint& point) { return !point.tolerance && point.solver != "spectral"; }

/// Whether it solved, and its error is one to be drawn: the exact solver's is that of rounding.
bool has_a_place(const StudyPoint& point) {
  return point.errors && (point.tolerance || is_model(point));
}

std::vector<const StudyPoint*> points_in(const std::vector<StudyPoint>& points,
                                         const StudySetting& setting) {
  std::vector<const StudyPoint*> chosen;
  for (const StudyPoint& point : points) {
    if (*point.setting == setting) chosen.push_back(&point);
  }
  return chosen;
}

/// The names of the solvers of the points that fulfil the condition.
template <class Condition>
Names names_of(const std::vector<const StudyPoint*>& points, Condition condition) {
  Names names;
  for (const StudyPoint* point : points) {
    if (condition(*point) && std::ranges::find(names, point->solver) == names.end()) {
      names.push_back(point->solver);
    }
  }
  return names;
}

/// gnuplot's string, in apostrophes: between quotation marks it would run what stands in backticks.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : printable(text)) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

/// The rows of one solver in column `y`; others are left out.
std::string of_solver(const std::string& solver, const std::string& x, const std::string& y) {
  return fmt::format("data using {}:(stringcolumn(1) eq {} ? {} : NaN)", x, quoted(solver), y);
}

std::string joined(const Names& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", \\\n  ") + part;
  return text + "\n";
}

/// The least error of the solvers with steps, and which has it.
const StudyPoint* best_with_steps(const std::vector<const StudyPoint*>& points) {
  const StudyPoint* best = nullptr;
  for (const StudyPoint* point : points) {
    if (!point->tolerance || !point->errors) continue;
    if (!best || point->errors->displacement_l2_max < best->errors->displacement_l2_max) {
      best = point;
    }
  }
  return best;
}

}  // namespace

ShortNames::ShortNames(const std::vector<StudySetting>& all) {
  const auto differs = [&](auto member) {
    return std::ranges::any_of(
        all, [&](const StudySetting& other) { return other.*member != all.front().*member; });
  };
  filter_ = differs(&StudySetting::filter);
  samples_ = differs(&StudySetting::samples);
  levels_ = !samples_ && differs(&StudySetting::levels);
  shape_ = differs(&StudySetting::shape);
  mass_damping_ = differs(&StudySetting::mass_damping);
  stiffness_damping_ = differs(&StudySetting::stiffness_damping);
}

std::string ShortNames::operator()(const StudySetting& setting) const {
  std::string name;
  const auto add = [&](bool is_needed, const std::string& part) {
    if (is_needed) name += (name.empty() ? "" : ", ") + part;
  };
  add(filter_, setting.filter);
  add(samples_, fmt::format("N = {}", setting.samples));
  add(levels_, fmt::format("{} levels", setting.levels));
  add(shape_, setting.shape);
  add(mass_damping_, fmt::format("s_1 = {}", setting.mass_damping));
  add(stiffness_damping_, fmt::format("s_2 = {}", setting.stiffness_damping));
  return name.empty() ? setting.shape : name;
}

Chart floors_chart(const std::vector<StudyPoint>& points) {
  const std::vector<StudySetting> settings = settings_of(points);
  const ShortNames short_name(settings);
  std::vector<const StudyPoint*> all;
  for (const StudyPoint& point : points) all.push_back(&point);
  const Names models = names_of(all, is_model);
  Chart chart;
  chart.id = "floors";
  chart.data = {
      "Where each curve ends: the largest L2 error of the displacement for 0 <= t <= 1, "
      "relative to the initial one. Models end at a floor; solvers with steps can go on",
      {"setting"},
      {}};
  for (const std::string& model : models) chart.data.columns.push_back(model + ", model error");
  chart.data.columns.insert(chart.data.columns.end(), {"least with steps", "by", "at"});
  for (const StudySetting& setting : settings) {
    const auto here = points_in(points, setting);
    Names row = {short_name(setting)};
    for (const std::string& model : models) {
      const auto found = std::ranges::find(here, model, &StudyPoint::solver);
      row.push_back(found != here.end() && (*found)->errors
                        ? number((*found)->errors->displacement_l2_max)
                        : "failed");
    }
    const StudyPoint* best = best_with_steps(here);
    row.push_back(best ? number(best->errors->displacement_l2_max) : "-");
    row.push_back(best ? best->solver : "-");
    row.push_back(best ? number(best->tolerance) : "-");
    chart.data.rows.push_back(row);
  }
  if (std::ranges::none_of(points, has_a_place)) return chart;
  Names plots;
  for (std::size_t i = 0; i <= models.size(); ++i) {
    plots.push_back(fmt::format("data using {}:xticlabels(1) with points linetype {} pointsize 1.3",
                                i + 2, i + 1));
  }
  plots.push_back(fmt::format("{} with lines linetype 5 title \"{:.0f} %, hardly seen\"",
                              small_error, 100 * small_error));
  chart.script = fmt::format(
      "{}set logscale y\nset format y \"10^{{%T}}\"\nset ylabel \"largest error relative to the "
      "initial displacement\"\nset xtics rotate by -25 noenhanced\nset yrange [*:10]\nset "
      "xrange [-0.5:{}]\nplot {}",
      more_lines, static_cast<double>(settings.size()) - 0.5, joined(plots));
  return chart;
}

Chart work_precision_chart(const std::vector<StudyPoint>& points, const StudySetting& setting,
                           int number_of_chart) {
  const auto here = points_in(points, setting);
  Chart chart;
  chart.id = fmt::format("work-precision-{}", number_of_chart);
  chart.data = {
      "Work against precision: the largest L2 error of the displacement, relative to the "
      "initial one, over the arithmetic operations of the whole solve; " +
          name_of(setting),
      {"solver", "tolerance", "operations", "evaluations", "seconds", "L2, largest", "L2, final",
       "maximum norm", "velocity", "energy norm", "energy drift"},
      {}};
  for (const StudyPoint* point : here) {
    Names row = {point->solver, number(point->tolerance)};
    if (const auto& errors = point->errors) {
      row.insert(row.end(),
                 {number(static_cast<double>(point->cost.operations)),
                  std::to_string(point->cost.evaluations), number(point->seconds),
                  number(errors->displacement_l2_max), number(errors->displacement_l2_final),
                  number(errors->maximum_norm_max), number(errors->velocity_l2_max),
                  number(errors->energy_norm_max), number(errors->energy_drift)});
    } else {
      row.insert(row.end(), 9, "failed");
      row.back() = "failed: " + point->failure;
    }
    chart.data.rows.push_back(row);
  }
  Names plots;
  std::string labels;
  for (const StudyPoint* point : here) {
    if (point->tolerance || !point->errors) continue;
    if (is_model(*point)) {
      const double floor = point->errors->displacement_l2_max;
      plots.push_back(
          fmt::format("{} with lines linecolor rgb \"#333333\" linewidth 1.5 dashtype {} notitle",
                      floor, plots.size() + 2));
      labels += fmt::format(
          "set label {} at graph 0.98, first {} right offset 0,{} font \",12\"\n",
          quoted(fmt::format("{}: floor {:.2g}, its model error", point->solver, floor)), floor,
          plots.size() == 1 ? "0.5" : "-0.6");  // floors may be near each other
    } else {
      labels += fmt::format(
          "set arrow from {0}, graph 0 to {0}, graph 1 nohead linecolor rgb \"#777777\" dashtype "
          "3\n"
          "set label \"spectral: exact\" at {0}, graph 0.03 rotate by 90 offset -0.8,0 "
          "font \",12\"\n",
          point->cost.operations);
    }
  }
  int type = 0;
  for (const std::string& solver :
       names_of(here, [](const StudyPoint& point) { return point.tolerance.has_value(); })) {
    plots.push_back(of_solver(solver, "3", "$6") + " with linespoints linetype " +
                    std::to_string(++type) + " title " + quoted(solver));
  }
  if (std::ranges::none_of(here, [](const auto* point) { return has_a_place(*point); })) {
    return chart;
  }
  chart.script = fmt::format(
      "{}set logscale xy\nset format xy \"10^{{%T}}\"\nset xlabel \"operations\"\n"
      "set ylabel \"largest error relative to the initial displacement\"\nset yrange [*:10]\n"
      "{}plot {}",
      more_lines, labels, joined(plots));
  return chart;
}

Chart model_error_chart(const std::vector<StudyPoint>& points, const StudySetting& setting,
                        int number_of_chart) {
  Chart chart;
  chart.id = fmt::format("model-error-{}", number_of_chart);
  chart.data = {
      "The model's error over time: its L2 norm relative to that of the initial "
      "displacement; " +
          name_of(setting),
      {"t"},
      {}};
  std::vector<const StudyPoint*> models;
  for (const StudyPoint* point : points_in(points, setting)) {
    if (is_model(*point) && point->errors) models.push_back(point);
  }
  if (models.empty()) return chart;
  Names plots;
  for (const StudyPoint* model : models) {
    chart.data.columns.push_back(model->solver);
    plots.push_back(fmt::format("data using 1:{} with linespoints linetype {}",
                                chart.data.columns.size(), plots.size() + 1));
  }
  plots.push_back(fmt::format("{} with lines linetype 5 title \"{:.0f} %, hardly seen\"",
                              small_error, 100 * small_error));
  const Eigen::VectorXd times = study_times();
  for (Eigen::Index i = 0; i < times.size(); ++i) {
    Names row = {number(times[i])};
    for (const StudyPoint* model : models) {
      row.push_back(number(model->model_errors.at(static_cast<std::size_t>(i))));
    }
    chart.data.rows.push_back(row);
  }
  chart.script =
      "set xlabel \"time t, of which 1 is a swing of the slowest mode\"\n"
      "set ylabel \"error relative to the initial displacement\"\nset yrange [0:*]\nplot " +
      joined(plots);
  return chart;
}

Table orders_table(const StudySummary& summary) {
  Table table{
      "Observed orders: the error falls as the evaluations to this power, fitted over the points "
      "in the asymptotic range, with an interval of 95 % (Student's)",
      {"setting", "solver", "order", "from", "to", "points", "coarsest", "finest"},
      {}};
  for (const ObservedOrder& order : summary.orders) {
    table.rows.push_back({name_of(*order.setting), order.solver,
                          fmt::format("{:.2f}", order.fit.exponent),
                          fmt::format("{:.2f}", order.fit.low),
                          fmt::format("{:.2f}", order.fit.high), std::to_string(order.fit.points),
                          number(order.tolerances.front()), number(order.tolerances.back())});
  }
  return table;
}

Table growth_table(const StudySummary& summary) {
  Table table{
      "Growth of the costs with the number of samples N, as powers of N, with intervals of "
      "95 % (Student's)",
      {"setting", "solver", "tolerance", "N from", "to", "operations", "interval", "seconds",
       "interval"},
      {}};
  const auto interval = [](const PowerFit& fit) {
    return fmt::format("{:.2f} to {:.2f}", fit.low, fit.high);
  };
  for (const Growth& growth : summary.growth) {
    table.rows.push_back(
        {name_of(*growth.setting), growth.solver, number(growth.tolerance),
         std::to_string(growth.samples.front()), std::to_string(growth.samples.back()),
         fmt::format("{:.2f}", growth.operations.exponent), interval(growth.operations),
         fmt::format("{:.2f}", growth.seconds.exponent), interval(growth.seconds)});
  }
  return table;
}

}  // namespace wavecurve::reports
