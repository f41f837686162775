#include "tools/commands/coefficients_quantity.hpp"

#include <utility>

#include <fmt/format.h>

#include "wavecurve/certified/integrals/integral_decimals.hpp"
#include "wavecurve/io/load_filter.hpp"

#include "tools/commands/output/number_list.hpp"
#include "verification/quantities/integral_expression.hpp"

namespace wavecurve::tools {

namespace {

using namespace wavecurve::verification;
using nlohmann::ordered_json;

ordered_json indices_as_json(const EntryIndex& index) {
  if (index.is_pair) return {static_cast<int>(index.first), static_cast<int>(index.second)};
  if (index.is_integer()) return ordered_json::array({index.integer()});
  return ordered_json::array({index.text()});
}

}  // namespace

std::string quantity_output(const std::string& filter, const std::string& quantity,
                            const ListingRequest& request, const std::string& format) {
  const Quantity parsed = parse_quantity(quantity);
  FilterValues values(find_table_filter(filter));
  const std::string name = to_string(parsed);
  NumberList list{values.name(), name, {{"quantity", name}, {"on", nullptr}}, {}};
  for (auto& [index, number] : list_quantity(values, parsed, request)) {
    list.entries.push_back({index.text(), indices_as_json(index), std::move(number)});
  }
  return number_list_output(list, format);
}

std::string integral_output(const std::string& filter, const std::string& integral,
                            const IntegralRange& range, int digits, const std::string& format) {
  const auto& [on, period] = range;
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
