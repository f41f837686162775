#include "tools/commands/coefficients/quantity_output.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/certified/integrals/integral_decimals.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/load_filter.hpp"

#include "tools/commands/output/number_list.hpp"
#include "verification/quantities/integral_expression.hpp"

namespace wavecurve::tools {

namespace {

using namespace wavecurve::verification;
using nlohmann::ordered_json;

ordered_json indices_as_json(const EntryIndex& index) {
  ordered_json indices = ordered_json::array();
  if (index.dyadic_level() == 0) {
    indices.push_back(static_cast<int>(index.first));
  } else {
    indices.push_back(index.first_text());
  }
  if (index.count > 1) indices.push_back(index.second);
  if (index.count > 2) indices.push_back(index.third);
  return indices;
}

std::vector<ListedNumber> quantity_entries(FilterValues& values, const Quantity& quantity,
                                           const ListingRequest& request) {
  std::vector<ListedNumber> entries;
  for (auto& [index, number] : list_quantity(values, quantity, request)) {
    entries.push_back({index.text(), indices_as_json(index), std::move(number)});
  }
  return entries;
}

/// The quantity that is the integral from 0 to x; the factors stand at whole shifts of one level.
Quantity integral_up_to_x(const std::string& integral) {
  // On an interval any factor may have a letter, or none.
  const ProductIntegral parsed = parse_integral(integral, DyadicInterval{});
  const bool has_levels = std::ranges::any_of(
      parsed.factors, [](const IntegralFactor& factor) { return factor.level > 0; });
  if (parsed.power > 0 || has_levels) {
    throw std::invalid_argument(
        must_be("the integral", integral, "one of phi and psi at x or x - l, for --on 0,x"));
  }
  return parse_quantity("int(" + to_string(parsed) + ") on [0,x]");
}

std::string up_to_x_output(const std::string& filter, const std::string& integral,
                           const ListingRequest& request, const std::string& format) {
  const Quantity quantity = integral_up_to_x(integral);
  FilterValues values(find_table_filter(filter));
  NumberList list{values.name(),
                  to_string(quantity),
                  {{"integral", integral}, {"on", "0,x"}},
                  quantity_entries(values, quantity, request)};
  return number_list_output(list, format);
}

}  // namespace

std::string quantity_output(const std::string& filter, const std::string& quantity,
                            const ListingRequest& request, const std::string& format) {
  const Quantity parsed = parse_quantity(quantity);
  FilterValues values(find_table_filter(filter));
  const std::string name = to_string(parsed);
  NumberList list{values.name(),
                  name,
                  {{"quantity", name}, {"on", nullptr}},
                  quantity_entries(values, parsed, request)};
  return number_list_output(list, format);
}

std::string integral_output(const std::string& filter, const std::string& integral,
                            const IntegralRange& range, int digits, const std::string& format) {
  const auto& [on, period, level] = range;
  if (on && is_up_to_x(*on)) return up_to_x_output(filter, integral, {digits, level, 0}, format);
  std::optional<DyadicInterval> interval;
  if (on) interval = parse_interval(*on);
  ProductIntegral parsed = parse_integral(integral, interval);
  parsed.period = period;
  const certified::FilterDefinition definition = io::load_filter(filter);
  NumberList list{definition.name, "int(" + to_string(parsed) + ")", {{"integral", integral}}, {}};
  list.head["on"] = on ? ordered_json(*on) : ordered_json();
  if (on) list.name += " on " + *on;
  if (period) {
    list.head["period"] = *period;
    list.name += fmt::format(" with period {}", *period);
  }
  for (auto& [indices, number] : certified::integral_decimals(definition, parsed, digits)) {
    list.entries.push_back(listed(indices, std::move(number)));
  }
  return number_list_output(list, format);
}

}  // namespace wavecurve::tools
