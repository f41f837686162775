#include "tools/commands/output/check_text.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/detail/characters.hpp"

#include "tools/commands/output/check_sentences.hpp"

namespace wavecurve::tools {

namespace {

using namespace wavecurve::verification;

constexpr std::size_t printed_column = 3;
constexpr std::size_t gap = 2;  ///< blanks between two columns

/// How many columns of a terminal a text takes: one a character of UTF-8, not one a byte.
std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

std::vector<std::string> head_cells(const CheckedTable& table) {
  std::vector<std::string> cells{"filter",    "quantity", "index",   "printed",
                                 "certified", "ulps",     "verdict", "detail"};
  for (const std::string& name : table.extra_columns) cells.push_back(printable(name));
  return cells;
}

std::vector<std::string> row_cells(const CheckedRow& row) {
  std::vector<std::string> cells{printable(row.entry.filter),
                                 to_string(row.entry.quantity),
                                 row.entry.index.text(),
                                 printable(row.entry.printed),
                                 row.certified,
                                 ulps_text(row.ulps, 3),
                                 std::string(to_string(row.verdict)),
                                 printable(row.detail)};
  for (const std::string& field : row.entry.extra) cells.push_back(printable(field));
  return cells;
}

std::vector<PrintPart> parts_of(const CheckedRow& row) {
  return marked_print(row.entry.printed, row.entry.number, row.departure);
}

class TextTable {
 public:
  TextTable(const CheckedTable& table, const CheckTextOptions& options) : options_(options) {
    widen(head_cells(table));
    for (const CheckedRow& row : table.rows) widen(row_cells(row));
  }

  std::string head(const CheckedTable& table) const {
    const std::vector<std::string> cells = head_cells(table);
    return line(cells, {{cells[printed_column], false}});
  }

  std::string row(const CheckedRow& row) const {
    const std::vector<PrintPart> parts = parts_of(row);
    const std::string text = line(row_cells(row), parts);
    return options_.explain && row.departure ? text + carets(parts) : text;
  }

 private:
  void widen(const std::vector<std::string>& cells) {
    widths_.resize(cells.size(), 0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      widths_[i] = std::max(widths_[i], columns(cells[i]));
    }
  }

  std::string line(const std::vector<std::string>& cells,
                   const std::vector<PrintPart>& parts) const {
    std::string result;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i == printed_column) {
        for (const PrintPart& part : parts) add_part(part, result);
      } else {
        result += cells[i];
      }
      result += std::string(widths_[i] - columns(cells[i]) + gap, ' ');
    }
    result.erase(result.find_last_not_of(' ') + 1);
    return result + "\n";
  }

  /// A missing sign shows as the blank where it should stand.
  void add_part(const PrintPart& part, std::string& line) const {
    constexpr std::string_view bold_red = "\x1b[1;31m", red_ground = "\x1b[41m", plain = "\x1b[0m";
    if (!options_.colour || !part.departs) {
      line += part.text;
    } else if (part.text.empty()) {
      line.pop_back();
      line += fmt::format("{} {}", red_ground, plain);
    } else {
      line += fmt::format("{}{}{}", bold_red, part.text, plain);
    }
  }

  std::string carets(const std::vector<PrintPart>& parts) const {
    std::string result;
    for (std::size_t i = 0; i < printed_column; ++i) result += std::string(widths_[i] + gap, ' ');
    for (const PrintPart& part : parts) {
      if (part.departs && part.text.empty()) result.back() = '^';
      result += std::string(columns(part.text), part.departs ? '^' : ' ');
    }
    result.erase(result.find_last_not_of(' ') + 1);
    return result + "\n";
  }

  CheckTextOptions options_;
  std::vector<std::size_t> widths_;
};

std::string list_of(const std::vector<std::string>& sentences) {
  std::string result;
  for (const std::string& sentence : sentences) result += "  " + printable(sentence) + "\n";
  return result;
}

}  // namespace

std::string check_as_text(const CheckedTable& table, const CheckTextOptions& options) {
  const TextTable text(table, options);
  std::string result = table.title.empty() ? "" : printable(table.title) + "\n\n";
  result += text.head(table);
  for (const CheckedRow& row : table.rows) result += text.row(row);
  const std::string conventions = list_of(convention_sentences(table));
  if (!conventions.empty()) result += "\nconventions\n" + conventions;
  result += "\nroutes\n" + list_of(habit_sentences(table)) + list_of(route_sentences(table)) + "\n";
  for (const auto& [verdict, count] : table.counts()) {
    result += fmt::format("{:>6} {}\n", count, to_string(verdict));
  }
  return result;
}

MarkupTable check_as_markup(const CheckedTable& table, bool plain) {
  MarkupTable result{table.title.empty() ? "Printed and certified values" : table.title,
                     head_cells(table),
                     {},
                     {}};
  for (const CheckedRow& row : table.rows) {
    const std::vector<std::string> cells = row_cells(row);
    result.rows.emplace_back(cells.begin(), cells.end());
    const PrintedNumber& number = row.entry.number;
    result.rows.back()[printed_column] =
        plain ? marked_print(number.text(), number, row.departure) : parts_of(row);
  }
  for (const auto& sentences :
       {convention_sentences(table), habit_sentences(table), route_sentences(table)}) {
    result.notes.insert(result.notes.end(), sentences.begin(), sentences.end());
  }
  return result;
}

}  // namespace wavecurve::tools
