#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verification/prints/printed_number.hpp"
#include "verification/quantities/convention.hpp"
#include "verification/quantities/entry_index.hpp"
#include "verification/quantities/quantity.hpp"

namespace wavecurve::verification {

struct PublishedEntry {
  int line = 0;        ///< in the file, from 1
  std::string filter;  ///< as the table names it
  Quantity quantity;
  EntryIndex index;
  std::string printed;  ///< as the table has it
  PrintedNumber number;
  std::vector<std::string> extra;  ///< fields of the columns that are not the reader's
};

/// A published table as data: text (RFC 4180) with the columns filter, quantity, index and printed
/// (or value) in any order and case, separated by commas, semicolons or tabs. Numbers have any form
/// that parse_printed_number reads; where no comma separates, they may have a decimal comma, all of
/// them. Columns of other names are kept. Lines that start with # are comments; "# title: ..." and
/// "# source: ..." are kept, "# filter: db4" and "# quantity: h" hold for the rows below that have
/// no field of their own for it, so that index,printed is a header; "# convention: reversed" says how
/// all columns depart from the library's order (convention.hpp). Lines end in LF, CR LF or CR;
/// UTF-8 and UTF-16, with or without a byte order mark, empty lines, blanks around a field and empty
/// fields behind the last column are accepted.
struct PublishedTable {
  std::string file, title, source;
  std::optional<StatedConvention> convention;  ///< of every column
  std::vector<std::string> extra_columns;      ///< names of the columns in PublishedEntry::extra
  std::vector<PublishedEntry> entries;

  /// "FILE:LINE: "
  std::string location(const PublishedEntry& entry) const;
};

/// What a table may have at most: the bytes of its file, and its rows.
inline constexpr std::size_t largest_table = std::size_t{64} << 20;
inline constexpr int most_rows = 500'000;

/// Throws std::invalid_argument "FILE:LINE: what is wrong" for anything that is no such table.
/// Whether filter and index exist is checked where the filter is known (check_table.hpp).
PublishedTable parse_published_table(std::string_view text, const std::string& file);

/// Throws also as io::read_file does.
PublishedTable read_published_table(const std::filesystem::path& path);

}  // namespace wavecurve::verification
