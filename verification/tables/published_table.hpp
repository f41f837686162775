#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "verification/tables/printed_number.hpp"

namespace wavecurve::verification {

/// What a column of a published table lists; the index of a tap is its n.
enum class Quantity {
  taps,             ///< "h": taps of phi's filter, sum sqrt 2
  taps_sum_2,       ///< "h*sqrt2": the same with the sum 2
  taps_sum_1,       ///< "h/sqrt2": the same with the sum 1
  autocorrelation,  ///< "alpha"
  mu,
  nu,
  mu_normalized,  ///< "mu/mu0"
  nu_normalized,  ///< "nu/nu0"
};

/// The name that tables use, such as "h*sqrt2".
std::string_view to_string(Quantity quantity);
bool is_taps(Quantity quantity);

struct PublishedEntry {
  int line = 0;        ///< in the file, from 1
  std::string filter;  ///< as the table names it
  Quantity quantity = Quantity::taps;
  int index = 0;
  std::string printed;  ///< as the table has it
  PrintedNumber number;
};

/// A published table as data: comma-separated text (RFC 4180) with the columns
/// filter,quantity,index,printed in any order; lines that start with # are comments, and
/// "# title: ..." and "# source: ..." are kept. Windows line ends, a byte order mark, empty lines
/// and blanks around a field are accepted.
struct PublishedTable {
  std::string file, title, source;
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
