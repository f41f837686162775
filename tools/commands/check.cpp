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
#include "verification/tables/check_table.hpp"
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

std::string table_as_json(const CheckedTable& table) {
  nlohmann::ordered_json result;
  result["table"] = table.title;
  result["rows"] = nlohmann::ordered_json::array();
  for (const CheckedRow& row : table.rows) {
    result["rows"].push_back({{"filter", row.entry.filter},
                              {"quantity", to_string(row.entry.quantity)},
                              {"index", row.entry.index},
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
         {column.scientific ? "significant_digits" : "decimals", column.digits},
         {"route", column.route},
         {"matched", column.matched},
         {"after_edit", column.after_edit},
         {"of", column.of}});
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
    result +=
        fmt::format("{},{},{},{},{},{},{},{},{}", io::csv_field(row.entry.filter),
                    to_string(row.entry.quantity), row.entry.index,
                    io::csv_field(row.entry.printed), to_string(row.verdict), row.certified,
                    ulps_text(row.ulps, 6), io::csv_field(row.detail), io::csv_field(row.route));
    for (const std::string& field : row.entry.extra) result += "," + io::csv_field(field);
    result += "\n";
  }
  return result;
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
    cells.push_back({row.entry.filter, std::string(to_string(row.entry.quantity)),
                     std::to_string(row.entry.index), row.entry.printed, row.certified,
                     ulps_text(row.ulps, 3), std::string(to_string(row.verdict)), row.detail});
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
  result += "\nroutes\n";
  for (const CheckedColumn& column : table.columns) {
    result += fmt::format("  {} {} ({}): {} of {} entries", column.filter,
                          to_string(column.quantity), form_text(column), column.matched, column.of);
    if (column.after_edit > 0) result += fmt::format(", {} after an edit", column.after_edit);
    result += " from " + column.route + "\n";
  }
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
          "quantities: h, h*sqrt2, h/sqrt2, alpha, mu, nu, mu/mu0, nu/nu0")
      ->required();
  command->add_option("--format", options->format, "text, json or csv")
      ->check(CLI::IsMember({"text", "json", "csv"}))
      ->capture_default_str();
  command->footer(
      "Verdicts: certified, form, published-route, misprint, agrees-to-digits, discrepant, "
      "undecided.\n"
      "Exit code: 0 if every value is right (certified, or right but for its form), 1 if one is "
      "not,\n"
      "2 if the file is no such table.");
  command->callback([options, &exit_code] { check_published_table(*options, exit_code); });
}

}  // namespace wavecurve::tools
