#pragma once

#include <compare>
#include <string>
#include <string_view>

namespace wavecurve::verification {

/// Where an entry stands in its column: an integer l, a dyadic point x of the line (both exact as
/// doubles), or a pair l, m of integers.
struct EntryIndex {
  double first = 0, second = 0;
  bool is_pair = false;

  EntryIndex() = default;
  EntryIndex(int l) : first(l) {}
  static EntryIndex at(double x);
  static EntryIndex pair(int l, int m);

  bool is_integer() const;
  /// The integer l. Throws std::domain_error if it is none.
  int integer() const;
  /// The smallest level >= 0 for which 2^level times the point is an integer.
  int dyadic_level() const;
  /// "3", "-1/2", "(2, -1)".
  std::string text() const;

  auto operator<=>(const EntryIndex&) const = default;
};

/// An integer "-3", a dyadic point "1/2" or "0.375", or a pair "(2, -1)", "2 -1", "2;-1". Throws
/// std::invalid_argument for anything else, for a point that is not dyadic, and beyond
/// largest_index.
EntryIndex parse_entry_index(std::string_view text);

/// No filter is nearly as long, and sums of two such indices are whole numbers still.
inline constexpr int largest_index = 1'000'000'000;

}  // namespace wavecurve::verification
