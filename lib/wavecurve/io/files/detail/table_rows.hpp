#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wavecurve::io {

/// A line of a table that holds anything.
struct TableRow {
  std::vector<std::string> cells;
  std::string_view text;  ///< the line, without a comment
  int line = 0;           ///< counted from 1
  bool after_gap =
      false;  ///< a line that holds nothing, or nothing but separators, comes before it
  /// The cells of the last comment before the first row, where that comment might be its header.
  std::vector<std::string> comment;
  char separator = ',';
};

/// The rows of a table as programs write them: lines that end in any of the usual ways; a byte order mark,
/// and a line `sep=;` of spreadsheets, are passed over. What follows a # at the begin of a line or
/// behind a blank is a comment. The first row decides what separates cells: the first of semicolon, tab,
/// comma that it holds outside of quotes; else blanks. Throws std::invalid_argument for UTF-16, and
/// naming the line for quotes that csv_fields() refuses.
void for_each_row(std::string_view text, const std::function<void(const TableRow&)>& read);

/// The number in a cell. Where the comma does not separate cells, it may stand for the decimal point.
std::optional<double> cell_number(std::string_view cell, char separator);

/// The words of a column's name, without a unit in brackets, behind a slash or as last word.
std::vector<std::string_view> column_words(std::string_view cell);

/// The name of a column, of which people write variants: those words in lower case, joined by _. "X (mm)",
/// "x [px]" and "X_mm" are x, "Pos X" is pos_x.
std::string column_name(std::string_view cell);

}  // namespace wavecurve::io
