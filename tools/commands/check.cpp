#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/csv.hpp"

#include "tools/commands/commands.hpp"
#include "verification/checker/check_table.hpp"
#include "verification/routes/route_chance.hpp"
#include "verification/tables/table_columns.hpp"

namespace wavecurve::tools {

namespace {

using namespace wavecurve::verification;

/// Six significant digits: a distance is there to be read, not to be computed with.
nlohmann::json short_number(double x) {
  if (!std::isfinite(x)) return nullptr;
  return std::stod(fmt::format("{:.6g}", x));
}

/// A distance, or nothing for a fraction, which has no last digit.
std::string ulps_text(double ulps, int digits) {
  return std::isnan(ulps) ? "" : fmt::format("{:.{}g}", ulps, digits);
}

std::string form_text(const CheckedColumn& column) {
  return fmt::format("{} {}", column.digits, column.scientific ? "significant digits" : "decimals");
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

std::string table_as_json(const CheckedTable& table) {
  nlohmann::ordered_json result;
  result["table"] = table.title;
  result["rows"] = nlohmann::ordered_json::array();
  for (const CheckedRow& row : table.rows) {
    result["rows"].push_back({{"filter", row.entry.filter},
                              {"quantity", to_string(row.entry.quantity)},
                              {"index", index_as_json(row.entry.index)},
                              {"printed", row.entry.printed},
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
  return result.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string table_as_csv(const CheckedTable& table) {
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

std::string chance_text(double chance) {
  return chance <= least_chance ? fmt::format("below {:g}", least_chance)
                                : fmt::format("{:.1g}", chance);
}

std::string column_text(const CheckedColumn& column) {
  std::string text =
      fmt::format("{} {} ({}): {} of {} entries", column.filter, to_string(column.quantity),
                  form_text(column), column.matched, column.of);
  if (column.after_edit > 0) text += fmt::format(", {} after an edit", column.after_edit);
  text += " from " + column.route;
  if (!column.credited) {
    if (column.matched == column.of) return text;
    return text + fmt::format("; none of {} other computations explains the rest",
                              column.routes.size() - 1);
  }
  text += fmt::format(" (chance {}", chance_text(column.chance));
  if (column.other_columns > 0) {
    text += fmt::format(" together with {} other column{}", column.other_columns,
                        column.other_columns == 1 ? "" : "s");
  }
  if (column.allowance > 0) {
    text += fmt::format("; rounding errors of up to {:.2g} units allowed for", column.allowance);
  }
  return text + ")";
}

std::string habit_text(const CheckedHabit& habit) {
  std::string text =
      fmt::format("{} of {} columns, {} of {} entries: {} (chance {})", habit.columns,
                  habit.of_columns, habit.matched, habit.of, habit.name, chance_text(habit.chance));
  constexpr std::size_t most_named = 8;
  for (std::size_t i = 0; i < std::min(habit.exceptions.size(), most_named); ++i) {
    text += (i == 0 ? "; not " : ", ") + habit.exceptions[i];
  }
  if (habit.exceptions.size() > most_named) {
    text += fmt::format(" and {} more", habit.exceptions.size() - most_named);
  }
  return text;
}

/// One sentence for each column that does not follow the library's own convention.
std::string conventions_text(const CheckedTable& table) {
  std::string result;
  for (const CheckedColumn& column : table.columns) {
    if (column.convention_text.empty()) continue;
    const std::string words =
        column.known_as.empty() ? column.convention_text
                                : fmt::format("{}, as {}", column.convention_text, column.known_as);
    result +=
        fmt::format("  {} {}: {}{}\n", column.filter, to_string(column.quantity), words,
                    column.convention.stated
                        ? ", as the table states"
                        : fmt::format(" (the table does not say so; \"# convention: {}\" would)",
                                      column.convention_text));
  }
  for (const CheckedColumn& column : table.columns) {
    if (column.solution.empty()) continue;
    result += fmt::format("  {} {}: {}; not the one called {}\n", column.filter,
                          to_string(column.quantity), column.solution, column.filter);
  }
  return result.empty() ? "" : "\nconventions\n" + result;
}

/// How many columns of a terminal a text takes: one a character of UTF-8, not one a byte.
std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

std::string table_as_text(const CheckedTable& table) {
  std::vector<std::vector<std::string>> cells{
      {"filter", "quantity", "index", "printed", "certified", "ulps", "verdict", "detail"}};
  cells[0].insert(cells[0].end(), table.extra_columns.begin(), table.extra_columns.end());
  for (const CheckedRow& row : table.rows) {
    cells.push_back({row.entry.filter, to_string(row.entry.quantity), row.entry.index.text(),
                     row.entry.printed, row.certified, ulps_text(row.ulps, 3),
                     std::string(to_string(row.verdict)), row.detail});
    cells.back().insert(cells.back().end(), row.entry.extra.begin(), row.entry.extra.end());
  }
  std::vector<std::size_t> widths(cells[0].size(), 0);
  for (const auto& row : cells) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columns(row[i]));
  }
  std::string result = table.title.empty() ? "" : table.title + "\n\n";
  for (const auto& row : cells) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += row[i] + std::string(widths[i] - columns(row[i]) + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + "\n";
  }
  result += conventions_text(table);
  result += "\nroutes\n";
  for (const CheckedHabit& habit : table.habits) result += "  " + habit_text(habit) + "\n";
  for (const CheckedColumn& column : table.columns) result += "  " + column_text(column) + "\n";
  result += "\n";
  for (const auto& [verdict, count] : table.counts()) {
    result += fmt::format("{:>6} {}\n", count, to_string(verdict));
  }
  return result;
}

struct CheckOptions {
  std::string table, format = "text";
};

void check_published_table(const CheckOptions& options, ExitCode& exit_code) {
  const CheckedTable table = check_table(read_published_table(options.table));
  const std::string text = options.format == "json"  ? table_as_json(table)
                           : options.format == "csv" ? table_as_csv(table)
                                                     : table_as_text(table);
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (!table.is_right()) exit_code = differs;
}

}  // namespace

void add_check_command(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand(
      "check", "Hold the numbers of a published table against their certified values");
  command
      ->add_option(
          "table", options->table,
          "text with the columns filter, quantity, index, printed (or value), separated\n"
          "by commas, semicolons or tabs; \"# filter: db4\" and \"# quantity: h\" stand for\n"
          "columns of their own; other columns are kept; numbers in any usual form;\n"
          "quantities: h, g, dual(h), alpha, mu, nu, r, int(phi'', phi), phi, moment(psi), ...\n"
          "with *sqrt2, /sqrt2, /first (`coefficients --help` has them all);\n"
          "\"# convention: reversed, negated, alternating, dual, shift K, from 0, *sqrt2\" says how\n"
          "all columns depart from the library's order")
      ->required();
  command->add_option("--format", options->format, "text, json or csv")
      ->check(CLI::IsMember({"text", "json", "csv"}))
      ->capture_default_str();
  command->footer(
      "Verdicts: certified, form, published-route, misprint, agrees-to-digits, discrepant, "
      "undecided.\n"
      "Exit code: 0 if every value is right (certified, or right but for its form) in the "
      "library's\n"
      "order or one that the table states, 1 if not, 2 if the file is no such table.");
  command->callback([options, &exit_code] { check_published_table(*options, exit_code); });
}

}  // namespace wavecurve::tools
