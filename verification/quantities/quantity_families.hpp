#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "wavecurve/certified/filter_definition.hpp"

#include "verification/quantities/entry_index.hpp"
#include "verification/quantities/quantity.hpp"

namespace wavecurve::verification {

/// The numbers of one quantity of one filter, as enclosures of one precision.
struct Sequence {
  /// The entry of an index, zero outside the support.
  std::function<certified::Ball(const EntryIndex&)> enclosure;
  /// The same as an exact fraction, where one is known.
  std::function<std::optional<certified::Rational>(const EntryIndex&)> exact;
  /// The indices that a table may list; all of a tuple alike. Integrals have a zero at either end.
  int first = 0, last = 0;
};

/// One kind of quantity: how it is written, what it means, how it is computed. This is the one
/// table of quantities; a new one is a row of it.
struct QuantityFamily {
  std::string_view name;     ///< in the grammar of quantity.hpp
  std::string_view meaning;  ///< with its index, for help and documentation
  std::string_view example;
  /// How many functions stand in its brackets; 0 if the name alone says all.
  int fewest_factors = 0, most_factors = 0;
  /// The sequence to `bits` bits. `sample` is an index that is asked for: its level says how fine
  /// the points are, its size how many moments. Throws std::domain_error where there is none.
  Sequence (*compute)(const certified::FilterDefinition& definition, const Quantity& bare,
                      const EntryIndex& sample, long bits);
};

std::span<const QuantityFamily> quantity_families();

/// The family of a name. Throws std::invalid_argument if there is none.
const QuantityFamily& quantity_family(std::string_view name);

}  // namespace wavecurve::verification
