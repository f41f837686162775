#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/filters/detail/filter_name.hpp"

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
Family halfband_pair_family();

/// The rbioD.E of every biorD.E among the names and the aliases of the other families.
Family reversed_pair_family(const std::vector<Family>& others);

/// The definition of an orthonormal family whose autocorrelation is that of P_N: Daubechies,
/// symlets.
ExactAutocorrelations halfband_autocorrelations(int order);

/// The bank of an orthonormal filter from its taps over sqrt 2, sum 1.
FilterBank<Ball> orthonormal_bank(const std::string& name, Filter<Ball> mask,
                                  int vanishing_moments);

using BankOfOrder = std::function<FilterBank<Ball>(const std::string& name, int order)>;

/// The definition of the member of a family whose names are the prefix and an order, with `bank`
/// called at rising working precision. Empty for a name of another form; throws as require_order.
std::optional<FilterDefinition> define_by_order(std::string_view prefix, std::string_view name,
                                                int lowest, int highest, const BankOfOrder& bank);

/// Calls make() at rising working precision until every tap has `bits` bits of relative accuracy.
/// An exact zero is accurate. Throws std::runtime_error if 64 times the bits do not suffice.
FilterBank<Ball> with_accuracy(long bits, const std::function<FilterBank<Ball>()>& make);

}  // namespace wavecurve::certified
