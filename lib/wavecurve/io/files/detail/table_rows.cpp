#include "wavecurve/io/files/detail/table_rows.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/csv.hpp"
#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

/// The first line of a text, which is removed from it: lines end with a line feed, a carriage return, or both.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  const bool both = text.substr(end).starts_with("\r\n");
  text.remove_prefix(std::min(end + (both ? 2 : 1), text.size()));
  return line;
}

/// Where the comment of a line begins, or its size: values such as #ff0000 are none.
std::size_t comment_begin(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] != '#' || quoted) continue;
    if (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t') return i;
  }
  return line.size();
}

char separator_of(std::string_view line) {
  bool quoted = false, found[3] = {};
  constexpr std::string_view known = ";\t,";
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    const std::size_t which = known.find(c);
    if (!quoted && which != std::string_view::npos) found[which] = true;
  }
  const auto* first = std::find(std::begin(found), std::end(found), true);
  return first == std::end(found) ? ' ' : known[static_cast<std::size_t>(first - found)];
}

/// Several blanks in a row separate no more than one.
std::string with_single_blanks(std::string_view line) {
  std::string result;
  for (const char c : trimmed(line)) {
    const bool blank = c == ' ' || c == '\t';
    if (blank && result.ends_with(' ')) continue;
    result += blank ? ' ' : c;
  }
  return result;
}

std::vector<std::string> cells_of(std::string_view line, char separator) {
  if (separator != ' ') return csv_fields(line, separator);
  return csv_fields(with_single_blanks(line), ' ');
}

bool holds_nothing(std::string_view line) {
  return line.find_first_not_of(" \t\f,;\"") == std::string_view::npos;
}

/// Without what a pair of brackets encloses at the end.
std::string_view without_brackets(std::string_view name) {
  for (const std::string_view pair : {"()", "[]", "{}"}) {
    const std::size_t open = name.rfind(pair[0]);
    if (name.ends_with(pair[1]) && open != std::string_view::npos) {
      return trimmed(name.substr(0, open));
    }
  }
  return name;
}

bool is_unit(std::string_view word) {
  constexpr std::string_view units[] = {"m",  "cm", "mm",  "um",     "\xc2\xb5m", "nm",
                                        "km", "in", "px",  "pixel",  "pixels",    "pt",
                                        "s",  "ms", "sec", "seconds"};
  return std::find(std::begin(units), std::end(units), word) != std::end(units);
}

}  // namespace

void for_each_row(std::string_view text, const std::function<void(const TableRow&)>& read) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    throw std::invalid_argument("the text is UTF-16; save it as UTF-8");
  }
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  TableRow row;
  std::string_view comment;
  bool first = true, separator_known = false, gap = false;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    ++row.line;
    if (first && line.size() == 5 && lower_case(line.substr(0, 4)) == "sep=") {
      row.separator = line[4];
      separator_known = true;
      continue;
    }
    const std::size_t content = comment_begin(line);
    row.text = line.substr(0, content);
    if (holds_nothing(row.text)) {
      if (content < line.size()) {
        comment = line.substr(content + 1);  // a comment between lines separates nothing
      } else {
        gap = true;
      }
      continue;
    }
    try {
      if (first && !separator_known) row.separator = separator_of(row.text);
      row.cells = cells_of(row.text, row.separator);
      row.comment.clear();
      if (first && !comment.empty() && comment.find('"') == std::string_view::npos) {
        row.comment = cells_of(comment, row.separator);
      }
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("line {}: {}", row.line, error.what()));
    }
    row.after_gap = gap && !first;
    read(row);
    first = gap = false;
  }
}

std::optional<double> cell_number(std::string_view cell, char separator) {
  std::string with_point;
  if (separator != ',' && std::count(cell.begin(), cell.end(), ',') == 1 &&
      cell.find('.') == std::string_view::npos) {
    with_point = cell;
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    cell = with_point;
  }
  cell = trimmed(cell);
  if (cell.starts_with('+') && !cell.starts_with("+-")) cell.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::vector<std::string_view> column_words(std::string_view cell) {
  auto words = split(without_brackets(trimmed(cell)), " \t_-./:");
  if (words.size() > 1 && is_unit(lower_case(words.back()))) words.pop_back();
  return words;
}

std::string column_name(std::string_view cell) {
  return lower_case(fmt::format("{}", fmt::join(column_words(cell), "_")));
}

}  // namespace wavecurve::io
