#include "reports/write_study.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "reports/escape.hpp"
#include "reports/formula.hpp"
#include "reports/gnuplot.hpp"
#include "reports/html_evidence.hpp"
#include "reports/html_head.hpp"
#include "reports/study_charts.hpp"
#include "reports/study_overview.hpp"

namespace wavecurve::reports {

namespace {

namespace fs = std::filesystem;
using namespace verification;

constexpr const char* title = "Solvers of the equation of motion, compared";

constexpr const char* conditions =
    "Rest shape the unit circle, density and stiffness 1, released at rest, t from 0 to 1; errors "
    "against the exact motion at 41 equally spaced times. Integration error and model error are "
    "apart: what is solved in closed form has no tolerance, and ends at the floor of its model. "
    "Times are processor time of one thread, the minimum of up to five runs, with other solves "
    "running on the other cores. The energy drift is the largest change of the total energy since "
    "the start if there is no damping, the largest increase from one time to the next if there is.";

const Paragraph nothing_solved{
    "Every solve of this setting failed; the last column of the table has the reasons."};

bool any_solved(const std::vector<StudyPoint>& points, const StudySetting& setting) {
  return std::ranges::any_of(
      points, [&](const StudyPoint& point) { return *point.setting == setting && point.errors; });
}

/// ": a; b; c", or nothing if they are too many to be read.
std::string listed(const std::vector<std::string>& names) {
  if (names.empty() || names.size() > most_settings_shown) return "";
  return fmt::format(": {}", fmt::join(names, "; "));
}

std::string section(const std::string& heading, const std::vector<Evidence>& evidence,
                    const std::map<std::string, std::string>& figures, int number) {
  std::string html =
      fmt::format("<section aria-labelledby=\"part-{0}\">\n<h2 id=\"part-{0}\">{1}</h2>\n", number,
                  escape(heading));
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    html += html_of(evidence[i], figures, fmt::format("table-{}-{}", number, i));
  }
  return html + "</section>\n";
}

}  // namespace

std::vector<std::string> answer(const std::vector<StudyPoint>& points,
                                const StudySummary& summary) {
  const ShortNames short_name(settings_of(points));
  std::vector<std::string> sentences;
  for (const char* model : {"decoupled", "block-decoupled"}) {
    std::vector<double> floors;
    std::vector<std::string> small;
    for (const ErrorFloor& floor : summary.floors) {
      if (floor.solver != model) continue;
      floors.push_back(floor.displacement_l2_max);
      if (floors.back() <= small_error) small.push_back(short_name(*floor.setting));
    }
    if (floors.empty()) continue;
    const auto [least, largest] = std::ranges::minmax(floors);
    sentences.push_back(fmt::format(
        "{}: floor {}, its model error relative to the initial displacement; at most {:.0f} % in {} of {} "
        "settings{}.",
        model,
        floors.size() > 1 ? fmt::format("{:.2g} to {:.2g}", least, largest)
                          : fmt::format("{:.3g}", least),
        100 * small_error, small.size(), floors.size(), listed(small)));
  }
  const auto error = [](const StudyPoint& point) {
    return point.tolerance && point.errors ? point.errors->displacement_l2_max : INFINITY;
  };
  const auto best = std::ranges::min_element(points, {}, error);
  if (best != points.end() && std::isfinite(error(*best))) {
    sentences.push_back(fmt::format("Solvers with steps have no such floor: {} reaches {:.0e}.",
                                    best->solver, error(*best)));
  }
  return sentences;
}

namespace {

std::string answer_html(const std::vector<StudyPoint>& points, const StudySummary& summary) {
  std::string html = "<ul>\n";
  for (const std::string& sentence : answer(points, summary)) {
    html += "<li><strong>" + formula_html(sentence) + "</strong></li>\n";
  }
  return html + "</ul>\n";
}

}  // namespace

void write_study(const std::vector<StudyPoint>& points, const StudySummary& summary,
                 const fs::path& directory) {
  fs::create_directories(directory / "figures");
  std::map<std::string, std::string> figures;
  // A chart without a script has nothing to show but its table.
  const auto drawn = [&](const Chart& chart) -> Evidence {
    if (chart.script.empty()) return chart.data;
    draw_chart(chart, directory / "figures");
    figures[chart.id] = io::read_file(directory / "figures" / (chart.id + ".svg"));
    return chart;
  };
  std::string body;
  const std::vector<StudySetting> settings = settings_of(points);
  if (settings.size() > most_settings_shown) {
    std::vector<Evidence> overview = {drawn(accuracy_map(points))};
    for (const Table& table : {extremes_table(points, summary), influence_table(summary),
                               orders_overview(summary), growth_overview(summary)}) {
      if (!table.rows.empty()) overview.emplace_back(table);
    }
    body = section(fmt::format("{} points of {} settings, which the files hold one by one",
                               points.size(), settings.size()),
                   overview, figures, 0);
  } else {
    std::vector<Evidence> overview = {drawn(floors_chart(points))};
    const Table orders = orders_table(summary), growth = growth_table(summary);
    if (!orders.rows.empty()) overview.emplace_back(orders);
    if (!growth.rows.empty()) overview.emplace_back(growth);
    body = section("How accurate, at the end", overview, figures, 0);
    for (int number = 1; const StudySetting& setting : settings) {
      std::vector<Evidence> evidence;
      if (!any_solved(points, setting)) evidence.emplace_back(nothing_solved);
      evidence.push_back(drawn(work_precision_chart(points, setting, number)));
      const Chart model = model_error_chart(points, setting, number);
      if (!model.data.rows.empty()) evidence.push_back(drawn(model));
      body += section(name_of(setting), evidence, figures, number++);
    }
  }
  io::write_file(directory / "index.html",
                 html_head(title) + "<body>\n<header>\n<h1>" + title + "</h1>\n" +
                     answer_html(points, summary) + "<p>" + escape(conditions) +
                     "</p>\n<p class=\"files\"><a href=\"compare.json\">compare.json</a>, "
                     "<a href=\"compare.csv\">compare.csv</a></p>\n</header>\n<main>\n" +
                     body + "</main>\n</body>\n</html>\n");
}

}  // namespace wavecurve::reports
