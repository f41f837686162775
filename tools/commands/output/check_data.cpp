#include "tools/commands/output/check_data.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/csv.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"

#include "tools/commands/output/check_sentences.hpp"
#include "verification/prints/marked_print.hpp"
#include "verification/tables/table_columns.hpp"

namespace wavecurve::tools {

namespace {

using namespace wavecurve::verification;

/// Six significant digits: a distance is there to be read, not to be computed with.
nlohmann::json short_number(double x) {
  if (!std::isfinite(x)) return nullptr;
  return std::stod(fmt::format("{:.6g}", x));
}

/// A number where the index is an integer, as it always was; else its text.
nlohmann::ordered_json index_as_json(const EntryIndex& index) {
  if (index.is_integer()) return index.integer();
  return index.text();
}

nlohmann::ordered_json convention_as_json(const CheckedColumn& column) {
  const Convention& convention = column.convention;
  return {{"reversed", convention.reversed},
          {"negated", convention.negated},
          {"alternating", convention.alternating},
          {"dual", convention.exchanged},
          {"shift", convention.shift},
          {"scale", factor_text(convention.half_powers)},
          {"stated", convention.stated},
          {"known_as", column.known_as},
          {"words", column.convention_text}};
}

/// The print cut where it departs from the right number; put together, its texts are the print.
nlohmann::ordered_json parts_as_json(const CheckedRow& row) {
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  for (const PrintPart& part : marked_print(row.entry.printed, row.entry.number, row.departure)) {
    result.push_back({{"text", part.text}, {"departs", part.departs}});
  }
  return result;
}

}  // namespace

std::string check_as_json(const CheckedTable& table) {
  nlohmann::ordered_json result;
  result["table"] = table.title;
  result["rows"] = nlohmann::ordered_json::array();
  for (const CheckedRow& row : table.rows) {
    result["rows"].push_back({{"filter", row.entry.filter},
                              {"quantity", to_string(row.entry.quantity)},
                              {"index", index_as_json(row.entry.index)},
                              {"printed", row.entry.printed},
                              {"parts", parts_as_json(row)},
                              {"verdict", to_string(row.verdict)},
                              {"certified", row.certified},
                              {"ulps", short_number(row.ulps)},
                              {"detail", row.detail},
                              {"route", row.route.empty() ? nlohmann::ordered_json()
                                                          : nlohmann::ordered_json(row.route)}});
    for (std::size_t i = 0; i < table.extra_columns.size(); ++i) {
      result["rows"].back()["extra"][table.extra_columns[i]] = row.entry.extra[i];
    }
  }
  result["columns"] = nlohmann::ordered_json::array();
  for (const CheckedColumn& column : table.columns) {
    result["columns"].push_back(
        {{"filter", column.filter},
         {"quantity", to_string(column.quantity)},
         {"convention", convention_as_json(column)},
         {"solution", column.solution.empty() ? nlohmann::ordered_json()
                                              : nlohmann::ordered_json(column.solution)},
         {column.scientific ? "significant_digits" : "decimals", column.digits},
         {"route", column.route},
         {"matched", column.matched},
         {"after_edit", column.after_edit},
         {"of", column.of},
         {"tried", column.routes.size()},
         {"chance", column.credited ? nlohmann::ordered_json(short_number(column.chance))
                                    : nlohmann::ordered_json()},
         {"allowance", short_number(column.allowance)},
         {"pooled_with", column.other_columns}});
  }
  result["habits"] = nlohmann::ordered_json::array();
  for (const CheckedHabit& habit : table.habits) {
    result["habits"].push_back({{"route", habit.name},
                                {"matched", habit.matched},
                                {"of", habit.of},
                                {"columns", habit.columns},
                                {"of_columns", habit.of_columns},
                                {"chance", short_number(habit.chance)},
                                {"exceptions", habit.exceptions}});
  }
  result["counts"] = nlohmann::ordered_json::object();
  for (const auto& [verdict, count] : table.counts()) {
    result["counts"][std::string(to_string(verdict))] = count;
  }
  // A title or a name may hold bytes that are no UTF-8.
  return io::json_text(result, 2) + "\n";
}

std::string check_as_csv(const CheckedTable& table) {
  std::vector<std::string> names{"filter",    "quantity", "index",  "printed", "verdict",
                                 "certified", "ulps",     "detail", "route"};
  for (const std::string& name : table.extra_columns) unique_name(name, names);
  std::string result;
  for (const std::string& name : names) {
    result += (result.empty() ? "" : ",") + io::csv_field(name);
  }
  result += "\n";
  for (const CheckedRow& row : table.rows) {
    result += fmt::format("{},{},{},{},{},{},{},{},{}", io::csv_field(row.entry.filter),
                          io::csv_field(to_string(row.entry.quantity)),
                          io::csv_field(row.entry.index.text()), io::csv_field(row.entry.printed),
                          to_string(row.verdict), row.certified, ulps_text(row.ulps, 6),
                          io::csv_field(row.detail), io::csv_field(row.route));
    for (const std::string& field : row.entry.extra) result += "," + io::csv_field(field);
    result += "\n";
  }
  return result;
}

}  // namespace wavecurve::tools
