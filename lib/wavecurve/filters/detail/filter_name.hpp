#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wavecurve {

// How the names of numbered families are read: "db12", "bspline4.4".

/// "db12" with prefix "db" -> 12; empty if the rest is not a whole number without leading zero.
std::optional<int> number_after(std::string_view prefix, std::string_view name);

/// Throws std::invalid_argument naming the filter, its order and the bounds.
void require_order(std::string_view name, int order, int lowest, int highest);

struct SplineOrders {
  int order, dual_order;
};

/// The bound of either order; it keeps a typing slip from filling the memory.
inline constexpr int highest_spline_order = 100;

/// "bsplineD.E" -> {D, E}; empty for a name of another form. Throws std::invalid_argument for
/// orders out of 1 .. highest_spline_order or with an odd sum.
std::optional<SplineOrders> spline_orders(std::string_view name);

/// Throws std::invalid_argument for a name that stands for none of the known filters: of one that
/// other packages have, such as "fk8", with what it is and why it is not among them.
[[noreturn]] void refuse_filter_name(std::string_view name, const std::vector<std::string>& known);

}  // namespace wavecurve
