#include "history_page.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "bootstrap.hpp"
#include "change_points.hpp"
#include "limit_reasons.hpp"
#include "timing.hpp"

namespace wavecurve::tracking {

namespace {

using verification::Chart;
using verification::Evidence;
using verification::Paragraph;
using verification::Table;

/// One quantity over the records; not a number where a record does not have it.
using Series = std::vector<double>;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// Below these a series is taken to repeat: counts do to 2e-3 where memory is allocated; medians of
// times on a shared machine to a few percent.
constexpr double noise_of_counts = 1e-3, noise_of_times = 0.02, noise_of_accuracy = 1e-3;

double number(const Json& record, const std::string& pointer) {
  const Json::json_pointer place(pointer);
  return record.contains(place) && record[place].is_number() ? record[place].get<double>()
                                                             : missing;
}

/// By benchmark: median, least and largest processor time in seconds.
struct Times {
  double median, least, largest;
};
std::map<std::string, Times> times_of(const Json& record) {
  std::map<std::string, Times> times;
  for (const Json& entry : record.value("benchmarks", Json::array())) {
    if (!entry.contains("cpu_time")) continue;
    std::vector<double> all = entry["cpu_time"].get<std::vector<double>>();
    const double unit = seconds_of_unit(entry["time_unit"].get<std::string>());
    for (double& time : all) time *= unit;
    times[entry["name"].get<std::string>()] = {median(all), std::ranges::min(all),
                                               std::ranges::max(all)};
  }
  return times;
}

/// Indices of the records whose values begin a new level, of the values that are there.
std::vector<std::size_t> changes(const Series& series, double noise) {
  Series logs;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (!(series[i] > 0)) continue;
    logs.push_back(std::log(series[i]));
    places.push_back(i);
  }
  std::vector<std::size_t> result;
  for (const std::size_t i : change_points(logs, noise)) result.push_back(places[i]);
  return result;
}

std::string cell(double value) { return std::isnan(value) ? "?" : fmt::format("{:.4g}", value); }

std::string revision(const Json& record) {
  const std::string name = record["revision"].value("commit", "?").substr(0, 8);
  return record["revision"].value("is_dirty", false) ? name + "+" : name;
}

/// The chart of a kernel's times with its limits, in microseconds.
Chart time_chart(const std::string& id, const std::string& kernel, const std::vector<Json>& history,
                 const std::vector<std::map<std::string, Times>>& times, const std::string& name) {
  Chart chart;
  chart.id = id;
  chart.data = {
      fmt::format("{}: processor time of a run in µs, and what the machine could do", name),
      {"record", "revision", "median", "least", "largest", "copy of its data", "its arithmetic"},
      {}};
  Series medians;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const auto found = times[i].find(name);
    const bool is_there = found != times[i].end();
    const Times t = is_there ? found->second : Times{missing, missing, missing};
    const std::string limit = "/limits/kernels/" + kernel + "/";
    medians.push_back(t.median);
    chart.data.rows.push_back({std::to_string(i + 1), revision(history[i]), cell(t.median * 1e6),
                               cell(t.least * 1e6), cell(t.largest * 1e6),
                               cell(number(history[i], limit + "copy_seconds") * 1e6),
                               cell(number(history[i], limit + "arithmetic_seconds") * 1e6)});
  }
  chart.script =
      "set datafile missing \"?\"\nset logscale y\nset format y \"%g\"\n"
      "set ylabel \"µs a run\"\nset xlabel \"record (revision)\"\n";
  chart.script += fmt::format("set xrange [0.5:{}]\nset xtics rotate by -30\n",
                              static_cast<double>(history.size()) + 0.5);
  for (const std::size_t i : changes(medians, noise_of_times)) {
    chart.script += fmt::format(
        "set arrow from {0}, graph 0 to {0}, graph 1 nohead lc rgb "
        "\"#333333\" dashtype 3\n",
        static_cast<double>(i) + 0.5);
  }
  chart.script +=
      "plot data using 1:3:4:5:xtic(2) with yerrorbars lt 1 title \"median, least to largest\", "
      "\\\n"
      "  data using 1:6 with linespoints lt 2 title \"copy of its data\", \\\n"
      "  data using 1:7 with linespoints lt 3 title \"its arithmetic\"\n";
  return chart;
}

Chart count_chart(const std::string& id, const std::string& kernel,
                  const std::vector<Json>& history) {
  Chart chart;
  chart.id = id;
  chart.data = {kernel + ": instructions and data references of a run",
                {"record", "revision", "instructions", "data references"},
                {}};
  Series counts;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const std::string place = "/kernels/" + kernel + "/";
    counts.push_back(number(history[i], place + "instructions"));
    const double references =
        number(history[i], place + "data_reads") + number(history[i], place + "data_writes");
    const auto whole = [](double v) { return std::isnan(v) ? "?" : fmt::format("{:.0f}", v); };
    chart.data.rows.push_back(
        {std::to_string(i + 1), revision(history[i]), whole(counts.back()), whole(references)});
  }
  chart.script =
      "set datafile missing \"?\"\nset yrange [0:*]\nset format y \"%.3s %c\"\n"
      "set xlabel \"record (revision)\"\nset ylabel \"a run\"\n";
  chart.script += fmt::format("set xrange [0.5:{}]\nset xtics rotate by -30\n",
                              static_cast<double>(history.size()) + 0.5);
  for (const std::size_t i : changes(counts, noise_of_counts)) {
    chart.script += fmt::format(
        "set arrow from {0}, graph 0 to {0}, graph 1 nohead lc rgb "
        "\"#333333\" dashtype 3\n",
        static_cast<double>(i) + 0.5);
  }
  chart.script +=
      "plot data using 1:3:xtic(2) with linespoints lt 1 title \"instructions\", \\\n"
      "  data using 1:4 with linespoints lt 2 title \"data references\"\n";
  return chart;
}

std::string names_of(const std::vector<std::size_t>& places, const std::vector<Json>& history) {
  std::string text;
  for (const std::size_t i : places) text += (text.empty() ? "" : ", ") + revision(history[i]);
  return text.empty() ? "none" : text;
}

/// The larger of the limits, and its name.
std::pair<double, std::string> limit_of(const Json& record, const std::string& kernel) {
  const double copy = number(record, "/limits/kernels/" + kernel + "/copy_seconds");
  const double arithmetic = number(record, "/limits/kernels/" + kernel + "/arithmetic_seconds");
  if (std::isnan(copy) && std::isnan(arithmetic)) return {missing, ""};
  // A comparison with what is not known is false.
  return copy > arithmetic || std::isnan(arithmetic)
             ? std::pair{copy, std::string("copy")}
             : std::pair{arithmetic, std::string("arithmetic")};
}

std::string short_name(std::string name) {
  for (char& c : name) c = c == '_' || c == '.' ? '-' : c;
  return name;
}

Table accuracy_table(const std::vector<Json>& history) {
  Table table{"Every accuracy: its latest value, its smallest and largest, and where it changed",
              {"quantity", "kind", "latest", "smallest", "largest", "changed at"},
              {}};
  const Json latest = history.back().value("accuracy", Json::object());
  for (const auto& [name, entry] : latest.items()) {
    Series series;
    for (const Json& record : history) {
      series.push_back(number(record, "/accuracy/" + name + "/value"));
    }
    Series there;
    std::ranges::copy_if(series, std::back_inserter(there),
                         [](double v) { return !std::isnan(v); });
    table.rows.push_back({name, entry["kind"].get<std::string>(), cell(series.back()),
                          cell(there.empty() ? missing : std::ranges::min(there)),
                          cell(there.empty() ? missing : std::ranges::max(there)),
                          names_of(changes(series, noise_of_accuracy), history)});
  }
  return table;
}

Table other_times(const std::vector<Json>& history,
                  const std::vector<std::map<std::string, Times>>& times) {
  Table table{"Every benchmark of the latest record: median time in µs, and where it changed",
              {"benchmark", "median", "least", "largest", "changed at"},
              {}};
  for (const auto& [name, latest] : times.back()) {
    Series series;
    for (const auto& record : times) {
      series.push_back(record.contains(name) ? record.at(name).median : missing);
    }
    table.rows.push_back({name, cell(latest.median * 1e6), cell(latest.least * 1e6),
                          cell(latest.largest * 1e6),
                          names_of(changes(series, noise_of_times), history)});
  }
  return table;
}

/// Kernels that take more than 2.5 times what the machine allows.
Table far_from_limits(const Json& record, const std::map<std::string, Times>& times) {
  constexpr double far = 2.5;
  Table table{"More than 2.5 times the physical limit, and why",
              {"kernel", "times the limit", "limited by", "why"},
              {}};
  const Json kernels = record.value("kernels", Json::object());
  for (const auto& [kernel, counts] : kernels.items()) {
    const auto time = times.find(kernel + "/" + counts["size"].dump());
    const auto [limit, by] = limit_of(record, kernel);
    if (time == times.end() || !(time->second.median > far * limit)) continue;
    table.rows.push_back({kernel, cell(time->second.median / limit), by, limit_reason(kernel)});
  }
  return table;
}

}  // namespace

reports::Page history_page(const std::vector<Json>& history) {
  if (history.empty())
    throw std::invalid_argument("the history has 0 records; tools/bench.sh record adds one");
  std::vector<std::map<std::string, Times>> times;
  for (const Json& record : history) times.push_back(times_of(record));
  const Json& last = history.back();

  Table overview{"The marked kernels in the latest record; times in µs",
                 {"kernel", "time", "limit", "limited by", "times the limit", "instructions",
                  "time changed at", "instructions changed at"},
                 {}};
  std::vector<Evidence> charts;
  const Json kernels = last.value("kernels", Json::object());
  for (const auto& [kernel, counts] : kernels.items()) {
    const std::string name = kernel + "/" + counts["size"].dump();
    Series medians, instructions;
    for (std::size_t i = 0; i < history.size(); ++i) {
      medians.push_back(times[i].contains(name) ? times[i].at(name).median : missing);
      instructions.push_back(number(history[i], "/kernels/" + kernel + "/instructions"));
    }
    const auto [limit, by] = limit_of(last, kernel);
    overview.rows.push_back({name, cell(medians.back() * 1e6), cell(limit * 1e6), by,
                             cell(medians.back() / limit),
                             fmt::format("{:.0f}", instructions.back()),
                             names_of(changes(medians, noise_of_times), history),
                             names_of(changes(instructions, noise_of_counts), history)});
    // Records of counts alone have no times to draw.
    const bool is_timed = !std::ranges::all_of(medians, [](double t) { return std::isnan(t); });
    if (is_timed) {
      charts.emplace_back(time_chart("time-" + short_name(kernel), kernel, history, times, name));
    }
    charts.emplace_back(count_chart("count-" + short_name(kernel), kernel, history));
  }
  const Paragraph how{
      "Times are processor times, the median of a record's repetitions with their range; a "
      "record's "
      "machine was shared. The limits are measured in the same record: a copy of the data that the "
      "kernel must read and write, by memcpy, and its additions and multiplications at the rate of "
      "independent ones in the widest vectors. Change points (dotted lines) minimise penalised "
      "squares of the logarithms; a record from another machine makes one of its own. "
      "docs/how-to-read-benchmarks.md has the statistics."};
  const std::string generated = fmt::format(
      "{} records, the latest of {} at revision {} on {}", history.size(), last.value("date", "?"),
      revision(last), last.value("machine", Json::object()).value("cpu", "an unknown machine"));
  return {"Performance and accuracy over the records",
          generated,
          {{"Overview", {how, overview, far_from_limits(last, times.back())}},
           {"Accuracy", {accuracy_table(history)}},
           {"Kernel by kernel", charts},
           {"All benchmarks", {other_times(history, times)}}}};
}

}  // namespace wavecurve::tracking
