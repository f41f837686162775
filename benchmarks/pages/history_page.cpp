#include "benchmarks/pages/history_page.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "benchmarks/pages/history_charts.hpp"
#include "benchmarks/pages/history_series.hpp"

namespace wavecurve::tracking {

namespace {

using verification::Evidence;
using verification::Paragraph;
using verification::Table;

std::string names_of(const std::vector<std::size_t>& places, const std::vector<Json>& history) {
  std::string text;
  for (const std::size_t i : places) text += (text.empty() ? "" : ", ") + revision(history[i]);
  return text.empty() ? "none" : text;
}

/// The larger of the limits, and its name.
std::pair<double, std::string> limit_of(const Json& record, const std::string& kernel) {
  const double copy = number(record, {"limits", "kernels", kernel, "copy_seconds"});
  const double arithmetic = number(record, {"limits", "kernels", kernel, "arithmetic_seconds"});
  if (std::isnan(copy) && std::isnan(arithmetic)) return {missing, ""};
  // A comparison with what is not known is false.
  return copy > arithmetic || std::isnan(arithmetic)
             ? std::pair{copy, std::string("copy")}
             : std::pair{arithmetic, std::string("arithmetic")};
}

/// As a part of a file's name.
std::string short_name(std::string name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  for (char& c : name) c = is_plain(c) ? c : '-';
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
      series.push_back(number(record, {"accuracy", name, "value"}));
    }
    Series there;
    std::ranges::copy_if(series, std::back_inserter(there),
                         [](double v) { return !std::isnan(v); });
    table.rows.push_back({name, entry.at("kind").get<std::string>(), cell(series.back()),
                          cell(there.empty() ? missing : std::ranges::min(there)),
                          cell(there.empty() ? missing : std::ranges::max(there)),
                          names_of(changes(series, noise_of_accuracy), history)});
  }
  return table;
}

Table other_times(const std::vector<Json>& history, const std::vector<TimesByName>& times) {
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
Table far_from_limits(const Json& record, const TimesByName& times, const LimitReasons& reasons) {
  constexpr double far = 2.5;
  Table table{"More than 2.5 times the physical limit, and why",
              {"kernel", "times the limit", "limited by", "why"},
              {}};
  const std::string commit =
      record.value("revision", Json::object()).value("commit", std::string());
  const Json kernels = record.value("kernels", Json::object());
  for (const auto& [kernel, counts] : kernels.items()) {
    const auto time = times.find(kernel + "/" + counts.at("size").dump());
    const auto [limit, by] = limit_of(record, kernel);
    if (time == times.end() || !(time->second.median > far * limit)) continue;
    table.rows.push_back(
        {kernel, cell(time->second.median / limit), by, reasons.text(kernel, commit)});
  }
  return table;
}

}  // namespace

reports::Page history_page(const std::vector<Json>& history, const LimitReasons& reasons) {
  if (history.empty())
    throw std::invalid_argument("the history has 0 records; tools/bench.sh record adds one");
  std::vector<TimesByName> times;
  for (const Json& record : history) times.push_back(times_of(record));
  const Json& last = history.back();

  Table overview{"The marked kernels in the latest record; times in µs",
                 {"kernel", "time", "limit", "limited by", "times the limit", "instructions",
                  "time changed at", "instructions changed at"},
                 {}};
  std::vector<Evidence> charts;
  const Json kernels = last.value("kernels", Json::object());
  for (const auto& [kernel, counts] : kernels.items()) {
    const std::string name = kernel + "/" + counts.at("size").dump();
    Series medians, instructions;
    for (std::size_t i = 0; i < history.size(); ++i) {
      medians.push_back(times[i].contains(name) ? times[i].at(name).median : missing);
      instructions.push_back(number(history[i], {"kernels", kernel, "instructions"}));
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
      "record's machine was shared. The limits are measured in the same record: a copy of the data "
      "that the kernel must read and write, by memcpy, and its additions and multiplications at "
      "the rate of independent ones in the widest vectors. Change points (dotted lines) minimise "
      "penalised squares of the logarithms; a record from another machine makes one of its own. "
      "docs/how-to-read-benchmarks.md has the statistics."};
  const std::string generated =
      fmt::format("{} record{}, the latest of {} at revision {} on {}", history.size(),
                  history.size() == 1 ? "" : "s", last.value("date", "?"), revision(last),
                  last.value("machine", Json::object()).value("cpu", "an unknown machine"));
  return {"Performance and accuracy over the records",
          generated,
          {{"Overview", {how, overview, far_from_limits(last, times.back(), reasons)}},
           {"Accuracy", {accuracy_chart(history), accuracy_table(history)}},
           {"Kernel by kernel", charts},
           {"All benchmarks", {other_times(history, times)}}}};
}

}  // namespace wavecurve::tracking
