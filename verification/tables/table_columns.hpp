#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wavecurve::verification {

/// What the header of a table says: where each column stands, and what stands between them.
struct TableColumns {
  char separator = ',';  ///< or ';' or a tab
  std::size_t count = 0;
  std::optional<std::size_t> filter, quantity;
  std::size_t index = 0, printed = 0;
  std::vector<std::size_t> extra;        ///< columns of other names
  std::vector<std::string> extra_names;  ///< their names, each another one
};

/// The most columns that a table may have.
inline constexpr std::size_t most_columns = 64;

/// Reads a header: names in any case and order, "value" for "printed". A separator is the one that
/// gives most of the known names. Throws std::invalid_argument if index or printed is missing, or a
/// known name is there twice.
TableColumns parse_table_columns(std::string_view header);

/// The fields of a row under the header, as many as it has columns; empty ones beyond them, which
/// spreadsheets leave, are dropped. Throws std::invalid_argument for any other number of fields, and
/// as io::csv_fields does.
std::vector<std::string> parse_table_row(std::string_view row, const TableColumns& columns);

/// The name, or "NAME (2)" and so on if it is taken already; it is then taken, too.
std::string unique_name(const std::string& name, std::vector<std::string>& taken);

}  // namespace wavecurve::verification
