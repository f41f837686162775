#include "verification/checker/table_evidence.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "wavecurve/elementary/root.hpp"

namespace wavecurve::verification {

namespace {

std::string name_of(const PublishedEntry& entry) {
  return fmt::format("{}_{}", to_string(entry.quantity), entry.index.text());
}

/// The same in the letters of a formula: "α_3", "μ_1/μ_0".
std::string symbol_of(const PublishedEntry& entry) {
  const std::string quantity = to_string(entry.quantity), index = entry.index.text();
  if (quantity == "alpha") return "α_" + index;
  if (quantity == "mu") return "μ_" + index;
  if (quantity == "nu") return "ν_" + index;
  if (quantity == "mu/mu0") return "μ_" + index + "/μ_0";
  if (quantity == "nu/nu0") return "ν_" + index + "/ν_0";
  return name_of(entry);
}

}  // namespace

Table row_table(const CheckedTable& table) {
  Table result{table.title + ", row by row",
               {"entry", "print", "certified", "distance in last units", "verdict", "detail"},
               {}};
  for (const CheckedRow& row : table.rows) {
    result.rows.push_back({name_of(row.entry), row.entry.printed, row.certified,
                           fmt::format("{:.3g}", row.ulps), std::string(to_string(row.verdict)),
                           row.detail});
  }
  return result;
}

Table column_table(const CheckedTable& table) {
  Table result{"The computation that explains each column",
               {"column", "computation", "entries", "of these after an edit", "of", "chance"},
               {}};
  for (const CheckedColumn& column : table.columns) {
    result.rows.push_back({std::string(to_string(column.quantity)), column.route,
                           std::to_string(column.matched), std::to_string(column.after_edit),
                           std::to_string(column.of),
                           column.credited ? fmt::format("{:.1g}", column.chance) : ""});
  }
  return result;
}

Table route_table(const CheckedColumn& column, const std::string& start, std::size_t most) {
  std::vector<RouteScore> scores;
  for (const RouteScore& score : column.routes) {
    if (score.name.starts_with(start)) scores.push_back(score);
  }
  std::stable_sort(scores.begin(), scores.end(), [](const RouteScore& a, const RouteScore& b) {
    return a.matched != b.matched ? a.matched > b.matched : a.farthest < b.farthest;
  });
  const std::string which = start.empty() ? "" : " \"" + start + " ...\"";
  Table result{fmt::format("{}: the nearest of {} computations{} tried", to_string(column.quantity),
                           scores.size(), which),
               {"computation", "entries yielded", "of", "largest distance in last units"},
               {}};
  for (std::size_t i = 0; i < std::min(most, scores.size()); ++i) {
    result.rows.push_back({scores[i].name, std::to_string(scores[i].matched),
                           std::to_string(column.of), fmt::format("{:.3g}", scores[i].farthest)});
  }
  return result;
}

Chart deviation_chart(const CheckedTable& table, const std::string& id) {
  Chart chart;
  chart.id = id;
  chart.data = {"Distance of the prints from the true values; exact prints are left out",
                {"row", "entry", "distance", "half a unit of the last digit", "verdict"},
                {}};
  int number = 0;
  for (const CheckedRow& row : table.rows) {
    ++number;
    if (row.ulps == 0) continue;
    const double unit = 1 / whole_power(10, row.entry.number.decimals());
    chart.data.rows.push_back(
        {std::to_string(number), symbol_of(row.entry), fmt::format("{:.3e}", row.ulps * unit),
         fmt::format("{:.1e}", unit / 2), std::string(to_string(row.verdict))});
  }
  chart.script =
      "set logscale y\n"
      // A print with many more decimals than its column would squeeze the rest.
      "set yrange [1e-16:*]\n"
      "set format y '10^{%L}'\n"
      "set xlabel 'entry of the table'\n"
      "set ylabel '|print - true value|'\n"
      "set xtics rotate by -60 noenhanced\n"
      "set grid y\n"
      "plot data using 0:3:xtic(2) with points, data using 0:4 with lines\n";
  return chart;
}

ClaimVerdict verdict_of(const CheckedTable& table) {
  const auto counts = table.counts();
  const auto has = [&](PrintVerdict verdict) { return counts.contains(verdict); };
  if (has(PrintVerdict::discrepant) || has(PrintVerdict::agrees_to_digits)) {
    return ClaimVerdict::discrepant;
  }
  if (has(PrintVerdict::undecided)) return ClaimVerdict::undecided;
  if (has(PrintVerdict::published_route)) return ClaimVerdict::published_route;
  if (has(PrintVerdict::misprint)) return ClaimVerdict::discrepant;
  return has(PrintVerdict::form) ? ClaimVerdict::form : ClaimVerdict::certified;
}

Finding count_finding(const CheckedTable& table) {
  std::string words;
  std::vector<ClaimValue> values;
  for (const auto& [verdict, count] : table.counts()) {
    words += fmt::format("{}{{}} {}", words.empty() ? "" : ", ", to_string(verdict));
    values.push_back(counted(std::string(to_string(verdict)), count));
  }
  return {words, values};
}

}  // namespace wavecurve::verification
