#pragma once

#include <compare>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wavecurve::verification {

/// Where an entry stands in its column: an integer l or a dyadic point x of the line (both exact as
/// doubles), or that and up to most_indices - 1 more integers: (l, m), (x, l), (l, m, n).
struct EntryIndex {
  double first = 0;
  int second = 0, third = 0;
  int count = 1;

  EntryIndex() = default;
  EntryIndex(int l) : first(l) {}
  static EntryIndex at(double x);
  static EntryIndex pair(int l, int m);
  /// x and further integers, at most most_indices - 1 of them.
  static EntryIndex tuple(double x, std::span<const int> further);

  bool is_tuple() const { return count > 1; }
  /// One index, which is an integer.
  bool is_integer() const;
  /// The integer l. Throws std::domain_error if it is none.
  int integer() const;
  /// All numbers of a tuple. Throws std::domain_error if the first is no integer.
  std::vector<int> integers() const;
  /// The smallest level >= 0 for which 2^level times the point, or a tuple's first, is an integer.
  int dyadic_level() const;
  /// The point or a tuple's first: "3", "-1/2".
  std::string first_text() const;
  /// "3", "-1/2", "(2, -1)".
  std::string text() const;

  auto operator<=>(const EntryIndex&) const = default;
};

/// The most integers that an index has.
inline constexpr int most_indices = 3;

/// An integer "-3", a dyadic point "1/2" or "0.375", or several: "(2, -1)", "2 -1", "2;-1",
/// "(1/2, 0)", "(1, 0, -2)". Throws std::invalid_argument for anything else, for a point that is not
/// dyadic, for a second or third number that is no integer, and beyond largest_index.
EntryIndex parse_entry_index(std::string_view text);

/// No filter is nearly as long, and sums of two such indices are whole numbers still.
inline constexpr int largest_index = 1'000'000'000;

}  // namespace wavecurve::verification
