#include "wavecurve/filters/detail/filter_name.hpp"

#include <charconv>
#include <stdexcept>
#include <string>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

std::optional<int> number_after(std::string_view prefix, std::string_view name) {
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  if (name.empty() || name.front() == '0' || name.front() == '-') return std::nullopt;
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
  return number;
}

void require_order(std::string_view name, int order, int lowest, int highest) {
  check_between("the order of filter " + std::string(name), order, lowest, highest);
}

std::optional<SplineOrders> spline_orders(std::string_view name) {
  const auto dot = name.find('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const auto order = number_after("bspline", name.substr(0, dot));
  const auto dual_order = number_after("", name.substr(dot + 1));
  if (!order || !dual_order) return std::nullopt;
  require_order(name, *order, 1, highest_spline_order);
  require_order(name, *dual_order, 1, highest_spline_order);
  if ((*order + *dual_order) % 2 != 0) {
    throw std::invalid_argument(must_be("the sum of the orders of filter " + std::string(name),
                                        *order + *dual_order, "even"));
  }
  return SplineOrders{*order, *dual_order};
}

}  // namespace wavecurve
