#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verification/tables/convention.hpp"
#include "verification/tables/entry_index.hpp"
#include "verification/tables/printed_number.hpp"
#include "verification/tables/quantity.hpp"

namespace wavecurve::verification {

struct PublishedEntry {
  int line = 0;        ///< in the file, from 1
  std::string filter;  ///< as the table names it
  Quantity quantity;
  EntryIndex index;
  std::string printed;  ///< as the table has it
  PrintedNumber number;
};

/// A published table as data: comma-separated text (RFC 4180) with the columns
/// filter,quantity,index,printed in any order; lines that start with # are comments, and
/// "# title: ..." and "# source: ..." are kept. Windows line ends, a byte order mark, empty lines
/// and blanks around a field are accepted.
struct PublishedTable {
  std::string file, title, source;
  std::optional<StatedConvention> convention;  ///< of every column
  std::vector<PublishedEntry> entries;

  /// "FILE:LINE: "
  std::string location(const PublishedEntry& entry) const;
};

/// Throws std::invalid_argument "FILE:LINE: what is wrong" for anything that is no such table.
/// Whether filter and index exist is checked where the filter is known (check_table.hpp).
PublishedTable parse_published_table(std::string_view text, const std::string& file);

/// Throws also as io::read_file does.
PublishedTable read_published_table(const std::filesystem::path& path);

}  // namespace wavecurve::verification
