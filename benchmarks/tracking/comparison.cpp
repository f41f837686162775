#include "benchmarks/tracking/comparison.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace wavecurve::tracking {

namespace {

bool is_interval(const RatioInterval& ratio) { return ratio.lower != ratio.upper; }

std::string amount(const Row& row, double value) {
  if (row.quantity == "time") {
    if (value < 1e-6) return fmt::format("{:.4g} ns", value * 1e9);
    return value < 1e-3 ? fmt::format("{:.4g} µs", value * 1e6)
                        : fmt::format("{:.4g} ms", value * 1e3);
  }
  return row.quantity == "instructions" ? fmt::format("{:.0f}", value)
                                        : fmt::format("{:.4g}", value);
}

std::vector<std::string> cells(const Row& row) {
  return {row.benchmark,
          row.quantity,
          amount(row, row.before),
          amount(row, row.after),
          fmt::format("{:.4f}", row.ratio.ratio),
          is_interval(row.ratio) ? fmt::format("{:.3f} .. {:.3f}", row.ratio.lower, row.ratio.upper)
                                 : "",
          std::string(to_string(row.verdict)),
          row.note};
}

const std::vector<std::string> heading{"benchmark", "quantity", "before",  "after",
                                       "ratio",     "interval", "verdict", "note"};

/// As seen, not as bytes: µ is one column.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string aligned(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(heading.size());
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i)
      widths[i] = std::max(widths[i], width_of(line[i]));
  }
  std::string text;
  for (const auto& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string blanks(widths[i] - width_of(line[i]), ' ');
      const bool is_number = i >= 2 && i <= 4;
      row += is_number ? fmt::format("{}{}  ", blanks, line[i])
                       : fmt::format("{}{}  ", line[i], blanks);
    }
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

/// Worst first, then as measured: counts before times.
std::vector<Row> by_verdict(const Comparison& comparison) {
  std::vector<Row> rows = comparison.rows;
  const auto rank = [](const Row& row) {
    switch (row.verdict) {
      case Change::slower:
        return 0;
      case Change::inconclusive:
        return 1;
      case Change::faster:
        return 2;
      case Change::same:
        break;
    }
    return 3;
  };
  std::ranges::stable_sort(rows, {}, rank);
  return rows;
}

std::string summary(const Comparison& comparison) {
  std::string text;
  for (const Change verdict :
       {Change::slower, Change::faster, Change::inconclusive, Change::same}) {
    const auto count = std::ranges::count(comparison.rows, verdict, &Row::verdict);
    if (count > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, to_string(verdict));
  }
  constexpr const char* results[] = {"no regression", "regression"};
  const int code = comparison.exit_code();
  return (text.empty() ? "nothing measured" : text) + ": " +
         (code == 4 ? "inconclusive" : results[code]);
}

}  // namespace

Change Comparison::verdict_of(const std::string& benchmark) const {
  std::set<Change> seen;
  bool is_counted = false;
  for (const Row& row : rows) {
    if (row.benchmark != benchmark) continue;
    seen.insert(row.verdict);
    is_counted |= row.quantity != "time";
  }
  if (seen.contains(Change::slower)) return Change::slower;
  if (seen.contains(Change::faster)) return Change::faster;
  return seen.contains(Change::inconclusive) && !is_counted ? Change::inconclusive : Change::same;
}

int Comparison::exit_code() const {
  bool is_open = false;
  for (const Row& row : rows) {
    const Change verdict = verdict_of(row.benchmark);
    if (verdict == Change::slower) return 1;
    is_open |= verdict == Change::inconclusive;
  }
  return is_open ? 4 : 0;
}

std::string to_text(const Comparison& comparison, bool all) {
  std::string text = comparison.before + " -> " + comparison.after + "\n";
  for (const std::string& note : comparison.notes) text += "note: " + note + "\n";
  std::vector<std::vector<std::string>> lines{heading};
  for (const Row& row : by_verdict(comparison)) {
    if (all || row.verdict != Change::same) lines.push_back(cells(row));
  }
  if (lines.size() > 1) text += fmt::format("\n{}\n", aligned(lines));
  return text + summary(comparison) + "\n";
}

std::string to_markdown(const Comparison& comparison) {
  std::string text = fmt::format("### `{}` → `{}`: {}\n\n", comparison.before, comparison.after,
                                 summary(comparison));
  text +=
      "| benchmark | quantity | before | after | ratio | interval | verdict | note |\n"
      "|---|---|---:|---:|---:|---|---|---|\n";
  for (const Row& row : by_verdict(comparison)) {
    text += "|";
    for (const std::string& cell : cells(row)) text += fmt::format(" {} |", cell);
    text += "\n";
  }
  for (const std::string& note : comparison.notes) text += "\n" + note + "\n";
  return text;
}

Json to_json(const Comparison& comparison) {
  Json json = {{"before", comparison.before},
               {"after", comparison.after},
               {"exit_code", comparison.exit_code()},
               {"notes", comparison.notes},
               {"rows", Json::array()}};
  for (const Row& row : comparison.rows) {
    json["rows"].push_back({{"benchmark", row.benchmark},
                            {"quantity", row.quantity},
                            {"before", row.before},
                            {"after", row.after},
                            {"ratio", row.ratio.ratio},
                            {"lower", row.ratio.lower},
                            {"upper", row.ratio.upper},
                            {"verdict", to_string(row.verdict)},
                            {"note", row.note}});
  }
  return json;
}

}  // namespace wavecurve::tracking
