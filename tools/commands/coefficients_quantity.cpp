#include "tools/commands/coefficients_quantity.hpp"

#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/io/files/detail/csv.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"

#include "tools/commands/output/markup_table.hpp"
#include "tools/commands/output/number_format.hpp"

namespace wavecurve::tools {

namespace {

using namespace wavecurve::verification;
using nlohmann::ordered_json;
using Entries = std::vector<ListedEntry>;

ordered_json indices_as_json(const EntryIndex& index) {
  if (index.is_pair) return {static_cast<int>(index.first), static_cast<int>(index.second)};
  if (index.is_integer()) return ordered_json::array({index.integer()});
  return ordered_json::array({index.text()});
}

std::string as_json(const QuantityOutput& options, const std::string& filter,
                    const Quantity& quantity, const Entries& entries) {
  ordered_json document{{"filter", filter}};
  if (options.integral.empty()) {
    document["quantity"] = to_string(quantity);
  } else {
    document["integral"] = options.integral;
  }
  document["on"] = nullptr;  // the whole line
  document["entries"] = ordered_json::array();
  for (const auto& [index, number] : entries) {
    document["entries"].push_back(
        {{"indices", indices_as_json(index)},
         {"value", number.value},
         {"radius", number.radius},
         {"exact", number.exact ? ordered_json(*number.exact) : ordered_json()}});
  }
  return io::json_text(document, 2) + "\n";
}

std::string as_csv(const std::string& filter, const Quantity& quantity, const Entries& entries) {
  std::string text = "filter,quantity,index,value,radius,exact\n";
  for (const auto& [index, number] : entries) {
    text += fmt::format("{},{},{},{},{},{}\n", io::csv_field(filter),
                        io::csv_field(to_string(quantity)), io::csv_field(index.text()),
                        number.value, number.radius, number.exact.value_or(""));
  }
  return text;
}

std::string as_cpp(const std::string& filter, const Quantity& quantity, const Entries& entries) {
  std::vector<std::string> decimals;
  for (const ListedEntry& entry : entries) decimals.push_back(entry.number.value);
  return header_opening(fmt::format("{} of {}, indices {} to {}", to_string(quantity), filter,
                                    entries.front().index.text(), entries.back().index.text()),
                        filter) +
         header_array("values", decimals) + header_closing(filter);
}

MarkupTable as_markup(const std::string& filter, const Quantity& quantity, const Entries& entries) {
  MarkupTable table{to_string(quantity) + " of " + filter, {"index", "value"}, {}, {}};
  std::vector<certified::DecimalEnclosure> values;
  for (const auto& [index, number] : entries) {
    table.rows.push_back({index.text(), number.value});
    values.push_back(number);
  }
  table.notes.push_back(accuracy_text(values));
  return table;
}

std::string as_text(const std::string& filter, const Quantity& quantity, const Entries& entries) {
  std::string text = fmt::format("{} of {}\n\n", to_string(quantity), printable(filter));
  constexpr std::size_t longest_fraction = 40;
  for (const auto& [index, number] : entries) {
    text += fmt::format("{:>8}  {}{}  +- {}", index.text(),
                        number.value.starts_with('-') ? "" : " ", number.value, number.radius);
    if (number.exact && number.exact->size() <= longest_fraction) text += "  = " + *number.exact;
    text += "\n";
  }
  return text;
}

}  // namespace

std::string quantity_output(const QuantityOutput& options) {
  const Quantity quantity =
      parse_quantity(options.integral.empty() ? options.quantity : "int(" + options.integral + ")");
  FilterValues filter(find_table_filter(options.filter));
  const Entries entries = list_quantity(filter, quantity, options.request);
  if (options.format == "json") return as_json(options, filter.name(), quantity, entries);
  if (options.format == "csv") return as_csv(filter.name(), quantity, entries);
  if (options.format == "cpp") return as_cpp(filter.name(), quantity, entries);
  if (is_markup(options.format)) {
    return to_markup(as_markup(filter.name(), quantity, entries), options.format);
  }
  return as_text(filter.name(), quantity, entries);
}

}  // namespace wavecurve::tools
