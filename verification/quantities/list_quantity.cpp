#include "verification/quantities/list_quantity.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "wavecurve/certified/moments.hpp"
#include "wavecurve/certified/point_values.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::verification {

namespace {

certified::DecimalEnclosure decimal_of(const TrueValue& value, int digits) {
  if (value.exact) return certified::decimal_enclosure(*value.exact, digits);
  std::optional<certified::DecimalEnclosure> result;
  decide(value, [&](const certified::Ball& enclosure) {
    result = certified::decimal_enclosure(enclosure, digits);
    return result ? Decision::yes : Decision::undecided;
  });
  if (result) return *result;
  return certified::supported_decimal(value.enclosure(precision_limit_bits), digits);
}

/// Every one of these with every further integer from first to last.
std::vector<EntryIndex> with_further(const std::vector<EntryIndex>& indices, int first, int last) {
  std::vector<EntryIndex> longer;
  for (const EntryIndex& index : indices) {
    for (int m = first; m <= last; ++m) {
      const std::array<int, 2> further =
          index.is_tuple() ? std::array{index.second, m} : std::array{m, 0};
      longer.push_back(EntryIndex::tuple(
          index.first, std::span(further).first(static_cast<std::size_t>(index.count))));
    }
  }
  return longer;
}

std::vector<EntryIndex> indices_of(FilterValues& filter, const Quantity& quantity,
                                   const ListingRequest& request) {
  const bool is_moment = quantity.family->name == "moment";
  const auto [first, last] =
      is_moment ? std::pair(0, request.highest_moment) : filter.index_range(quantity);
  const bool has_points = quantity.family->name == "value" || quantity.up_to_x;
  const int level = has_points ? request.level : 0;
  std::vector<EntryIndex> indices;
  for (int k = first * (1 << level); k <= last * (1 << level); ++k) {
    indices.push_back(EntryIndex::at(std::ldexp(k, -level)));
  }
  for (int count = 1; count < quantity.index_count(); ++count) {
    indices = with_further(indices, first, last);
  }
  return indices;
}

/// Leaves out what vanishes before the first entry that does not, and behind the last.
void trim(std::vector<std::pair<EntryIndex, TrueValue>>& entries) {
  const auto vanishes = [](const auto& entry) { return entry.second.is_exactly_zero(); };
  while (entries.size() > 1 && vanishes(entries.back())) entries.pop_back();
  std::size_t zeros = 0;
  while (zeros + 1 < entries.size() && vanishes(entries[zeros])) ++zeros;
  entries.erase(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(zeros));
}

}  // namespace

std::vector<ListedEntry> list_quantity(FilterValues& filter, const Quantity& quantity,
                                       const ListingRequest& request) {
  check_at_least("number of significant digits", request.digits, 1);
  check_between("dyadic level", request.level, 0, certified::highest_dyadic_level);
  check_between("moment", request.highest_moment, 0, certified::highest_moment);
  std::vector<std::pair<EntryIndex, TrueValue>> entries;
  for (const EntryIndex& index : indices_of(filter, quantity, request)) {
    TrueValue value = filter.value(quantity, index);
    const bool is_between_tuples = index.is_tuple() && value.is_exactly_zero();
    if (!is_between_tuples) entries.emplace_back(index, std::move(value));
  }
  if (quantity.family->name != "moment") trim(entries);
  std::vector<ListedEntry> listed;
  for (const auto& [index, value] : entries) {
    listed.push_back({index, decimal_of(value, request.digits)});
  }
  return listed;
}

}  // namespace wavecurve::verification
