#include "wavecurve/filters/detail/filter_name.hpp"

#include <charconv>
#include <stdexcept>
#include <string>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

namespace {

constexpr const char* is_only_printed =
    "whose taps have no closed definition here; give them as a JSON file";
constexpr const char* is_continuous = "which has no filter of finitely many taps";

/// Filters of other packages that are not among ours, by the letters with which the names begin.
struct ForeignFilter {
  std::string_view letters, kind;
  const char* reason;
};

constexpr ForeignFilter foreign_filters[] = {
    {"batt", "a Battle-Lemarie filter", is_only_printed},
    {"beyl", "Beylkin's filter", is_only_printed},
    {"bl", "a best localized Daubechies filter", is_only_printed},
    {"dmey", "the discrete Meyer filter", is_only_printed},
    {"fk", "a Fejer-Korovkin filter", is_only_printed},
    {"han", "a filter of Han's", is_only_printed},
    {"mb", "a minimum-bandwidth filter", is_only_printed},
    {"qshift", "a q-shift filter of the dual-tree transform", is_only_printed},
    {"vaid", "Vaidyanathan's filter", is_only_printed},
    {"cgau", "a continuous wavelet", is_continuous},
    {"cmor", "a continuous wavelet", is_continuous},
    {"fbsp", "a continuous wavelet", is_continuous},
    {"gaus", "a continuous wavelet", is_continuous},
    {"mexh", "a continuous wavelet", is_continuous},
    {"meyr", "Meyer's wavelet", is_continuous},
    {"morl", "a continuous wavelet", is_continuous},
    {"shan", "a continuous wavelet", is_continuous},
};

}  // namespace

void refuse_filter_name(std::string_view name, const std::vector<std::string>& known) {
  const std::string_view letters = name.substr(0, name.find_first_of("0123456789._-"));
  for (const ForeignFilter& foreign : foreign_filters) {
    if (foreign.letters != letters) continue;
    throw std::invalid_argument("filter " + value_text(name) + " is " + std::string(foreign.kind) +
                                ", " + foreign.reason);
  }
  throw std::invalid_argument(unknown_name("filter", name, known));
}

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
