#include "benchmarks/pages/history_charts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace wavecurve::tracking {

namespace {

using verification::Chart;

Chart chart_over(const std::vector<Json>& history, std::string id, std::string title,
                 std::vector<std::string> columns) {
  Chart chart;
  chart.id = std::move(id);
  columns.insert(columns.begin(), {"record", "revision"});
  chart.data = {std::move(title), std::move(columns), {}};
  for (std::size_t i = 0; i < history.size(); ++i) {
    chart.data.rows.push_back({std::to_string(i + 1), revision(history[i])});
  }
  chart.script = fmt::format(
      "set datafile missing \"?\"\nset xlabel \"record (revision)\"\nset xrange [0.5:{}]\n"
      "set xtics rotate by -30\n",
      static_cast<double>(history.size()) + 0.5);
  return chart;
}

void mark_changes(Chart& chart, const Series& series, double noise) {
  for (const std::size_t i : changes(series, noise)) {
    chart.script += fmt::format(
        "set arrow from {0}, graph 0 to {0}, graph 1 nohead lc rgb \"#333333\" dashtype 3\n",
        static_cast<double>(i) + 0.5);
  }
}

void add_column(Chart& chart, const Series& values, const char* form = "{:.4g}") {
  for (std::size_t i = 0; i < values.size(); ++i) {
    chart.data.rows[i].push_back(
        std::isnan(values[i]) ? "?" : fmt::format(fmt::runtime(form), values[i]));
  }
}

Series over_history(const std::vector<Json>& history, const std::vector<std::string>& keys) {
  Series series;
  for (const Json& record : history) series.push_back(number(record, keys));
  return series;
}

Series in_microseconds(Series seconds) {
  for (double& value : seconds) value *= 1e6;
  return seconds;
}

}  // namespace

Chart time_chart(const std::string& id, const std::string& kernel, const std::vector<Json>& history,
                 const std::vector<TimesByName>& times, const std::string& name) {
  Series median, least, largest;
  for (const TimesByName& record : times) {
    const auto found = record.find(name);
    const Times t = found != record.end() ? found->second : Times{missing, missing, missing};
    median.push_back(t.median);
    least.push_back(t.least);
    largest.push_back(t.largest);
  }
  Chart chart = chart_over(history, id,
                           name + ": processor time of a run in µs, and what the machine could do",
                           {"median", "least", "largest", "copy of its data", "its arithmetic"});
  for (const Series& series :
       {median, least, largest,
        over_history(history, {"limits", "kernels", kernel, "copy_seconds"}),
        over_history(history, {"limits", "kernels", kernel, "arithmetic_seconds"})}) {
    add_column(chart, in_microseconds(series));
  }
  mark_changes(chart, median, noise_of_times);
  chart.script +=
      "set logscale y\nset format y \"%g\"\nset ylabel \"µs a run\"\n"
      "plot data using 1:3:4:5:xtic(2) with yerrorbars lt 1 title \"median, least to largest\", "
      "\\\n"
      "  data using 1:6 with linespoints lt 2 title \"copy of its data\", \\\n"
      "  data using 1:7 with linespoints lt 3 title \"its arithmetic\"\n";
  return chart;
}

Chart count_chart(const std::string& id, const std::string& kernel,
                  const std::vector<Json>& history) {
  const Series instructions = over_history(history, {"kernels", kernel, "instructions"});
  Series references = over_history(history, {"kernels", kernel, "data_reads"});
  const Series writes = over_history(history, {"kernels", kernel, "data_writes"});
  for (std::size_t i = 0; i < writes.size(); ++i) references[i] += writes[i];
  Chart chart = chart_over(history, id, kernel + ": instructions and data references of a run",
                           {"instructions", "data references"});
  add_column(chart, instructions, "{:.0f}");
  add_column(chart, references, "{:.0f}");
  mark_changes(chart, instructions, noise_of_counts);
  chart.script +=
      "set yrange [0:*]\nset format y \"%.3s %c\"\nset ylabel \"a run\"\n"
      "plot data using 1:3:xtic(2) with linespoints lt 1 title \"instructions\", \\\n"
      "  data using 1:4 with linespoints lt 2 title \"data references\"\n";
  return chart;
}

Chart accuracy_chart(const std::vector<Json>& history) {
  Chart chart =
      chart_over(history, "accuracy", "Accuracy: every quantity over its first value", {});
  std::string plot;
  int others = 0, column = 2;
  const Json latest = history.back().value("accuracy", Json::object());
  for (const auto& [name, entry] : latest.items()) {
    Series series = over_history(history, {"accuracy", name, "value"});
    const auto first = std::ranges::find_if(series, [](double v) { return v > 0; });
    if (first == series.end()) continue;
    const double unit = *first;
    for (double& value : series) value /= unit;
    const bool has_changed = std::ranges::any_of(
        series, [](double ratio) { return std::abs(std::log(ratio)) > noise_of_accuracy; });
    if (!has_changed) {
      ++others;
      continue;
    }
    chart.data.columns.push_back(name + " (" + entry.at("kind").get<std::string>() + ")");
    add_column(chart, series);
    mark_changes(chart, series, noise_of_accuracy);
    plot += fmt::format("data using 1:{}:xtic(2) with linespoints, \\\n  ", ++column);
  }
  chart.data.columns.push_back(fmt::format("{} quantities that never changed", others));
  add_column(chart, Series(history.size(), 1));
  chart.script += "set logscale y\nset ylabel \"times the first record's\"\nplot " + plot;
  chart.script += fmt::format("data using 1:{}:xtic(2) with linespoints lt 5\n", column + 1);
  return chart;
}

}  // namespace wavecurve::tracking
