#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "verification/prints/true_value.hpp"
#include "verification/quantities/entry_index.hpp"
#include "verification/quantities/quantity.hpp"
#include "verification/quantities/quantity_families.hpp"

namespace wavecurve::verification {

/// Everything about one filter that a table can list, computed when asked for and then kept.
class FilterValues {
 public:
  explicit FilterValues(certified::FilterDefinition definition);

  const std::string& name() const { return definition_.name; }
  bool is_orthonormal() const { return orthonormal_; }
  int first_tap() const { return first_tap_; }
  int number_of_taps() const { return number_of_taps_; }

  /// Throws std::domain_error if the quantity does not exist for the filter, or the index is beyond
  /// what a table lists (the support; of integrals also the zero at either end).
  TrueValue value(const Quantity& quantity, const EntryIndex& index);

  /// The indices that a table may list; of pairs the two alike. Throws as value does.
  std::pair<int, int> index_range(const Quantity& quantity);

 private:
  const Sequence& sequence(const Quantity& bare, const EntryIndex& sample, long bits);
  TrueValue bare_value(const Quantity& bare, const EntryIndex& index);
  TrueValue first_value(const Quantity& bare);

  certified::FilterDefinition definition_;
  bool orthonormal_ = false;
  int first_tap_ = 0, number_of_taps_ = 0;
  std::map<std::tuple<std::string, long, long>, Sequence> sequences_;
};

/// The filter that a table's row names: a known name or the path of a user's ".json" file, from the
/// working directory. Throws std::invalid_argument if there is none, or it is not what it claims.
certified::FilterDefinition find_table_filter(const std::string& name);

}  // namespace wavecurve::verification
