#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verification/quantities/filter_values.hpp"

namespace wavecurve::verification {

/// How the entries of a whole column follow from the library's values v of its quantity:
///   entry(n) = s sqrt(2)^half_powers v(m),   m = n + shift, or first + last - n + shift reversed,
/// first and last being the quantity's support, and s = -1 if negated, times (-1)^n if alternating.
struct Convention {
  bool reversed = false, negated = false, alternating = false;
  bool exchanged = false;  ///< of the dual functions
  int shift = 0;
  int half_powers = 0;
  bool stated = false;  ///< by the table itself

  bool operator==(const Convention&) const = default;
  /// True if the column lists the library's values as they are.
  bool is_the_librarys() const;
};

/// What a table says of its convention, "reversed, from 0": what it leaves open is nothing.
struct StatedConvention {
  Convention convention;
  std::optional<int> shift;  ///< if it says one
  bool from_zero = false;    ///< its first entry, at the index 0, is an end of the support
};

/// Words, separated by commas: reversed, negated, alternating, dual, shift K, from 0, and a factor
/// *sqrt2, /sqrt2, *2, /2. Throws std::invalid_argument for any other.
StatedConvention parse_convention(std::string_view text);

/// The quantity, with its factor and sign, of the values that a column lists.
Quantity listed_quantity(const Quantity& quantity, const Convention& convention);

/// The index of the library's value behind an entry, and the sign (-1)^n of its place.
EntryIndex source_index(FilterValues& filter, const Quantity& quantity,
                        const Convention& convention, const EntryIndex& index);

/// The value that the column should print. An entry outside the support is exactly zero if
/// `outside` allows that; else throws as FilterValues::value.
TrueValue conventional_value(FilterValues& filter, const Quantity& quantity,
                             const Convention& convention, const EntryIndex& index);

/// An entry as the search for a convention sees it.
struct EntryToPlace {
  EntryIndex index;
  double value = 0;
  double unit = 0;  ///< of the last digit
};

/// The simplest convention that makes nearly all entries right, if the library's own does not:
/// nothing if that does, or if none does. `stated` restricts the search to what the table says.
///
/// Right means here: within a unit of the last digit or 1e-4 of the column's largest entry, so that
/// a column of bad accuracy is recognised, too. Nearly all: all of up to three, all but an eighth
/// of more, at least one. Two entries that are larger than ten times that tolerance must be among
/// them; a single number has no convention.
std::optional<Convention> recognise_convention(FilterValues& filter, const Quantity& quantity,
                                               const std::vector<EntryToPlace>& entries,
                                               const std::optional<StatedConvention>& stated = {});

/// "reversed, from 0, times sqrt 2"; empty for the library's own.
std::string describe(FilterValues& filter, const Quantity& quantity, const Convention& convention);

/// The known package that prints such a column (docs/conventions.md): "PyWavelets dec_lo"; empty if
/// none is known.
std::string known_as(FilterValues& filter, const Quantity& quantity, const Convention& convention);

}  // namespace wavecurve::verification
