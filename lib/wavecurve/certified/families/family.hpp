#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wavecurve/certified/filter_definition.hpp"

namespace wavecurve::certified {

/// A family of filters: one file of this folder, which defines one function that returns this, and
/// one line in families.cpp.
struct Family {
  /// What the command line tells about its names: "db1-db38 (aliases haar, D2-D76)".
  std::string names;
  /// Canonical names; of an infinite family the first few.
  std::vector<std::string> members;
  /// Other names of each, as pairs (alias, canonical name).
  std::vector<std::pair<std::string, std::string>> aliases;
  /// The definition of a canonical name; empty for a name of another family. Throws
  /// std::invalid_argument for a name of this family that is out of its range.
  std::function<std::optional<FilterDefinition>(std::string_view name)> define;
  /// Whether the members get generated double and float tables; splines are rounded at run time.
  bool is_tabulated = true;
};

Family daubechies_family();
Family symlet_family();
Family coiflet_family();
Family spline_family();
Family cdf97_family();

/// The definition of an orthonormal family whose autocorrelation is that of P_N: Daubechies,
/// symlets.
ExactAutocorrelations halfband_autocorrelations(int order);

/// "db12" with prefix "db" -> 12; empty if the rest is not a whole number without leading zero.
std::optional<int> number_after(std::string_view prefix, std::string_view name);

/// Throws std::invalid_argument naming the filter, its order and the bounds.
void require_order(std::string_view name, int order, int lowest, int highest);

/// Calls make() at rising working precision until every tap has `bits` bits of relative accuracy.
/// An exact zero is accurate. Throws std::runtime_error if 64 times the bits do not suffice.
FilterBank<Ball> with_accuracy(long bits, const std::function<FilterBank<Ball>()>& make);

}  // namespace wavecurve::certified
