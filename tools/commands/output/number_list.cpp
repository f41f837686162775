#include "tools/commands/output/number_list.hpp"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/io/files/detail/csv.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"

#include "tools/commands/output/markup_table.hpp"
#include "tools/commands/output/number_format.hpp"

namespace wavecurve::tools {

namespace {

using nlohmann::ordered_json;
using Numbers = std::span<const ListedNumber>;

/// Calls visit(quantity, numbers) for every run of one quantity; for the whole list if it has one.
void visit_quantities(const NumberList& list,
                      const std::function<void(const std::string&, const Numbers&)>& visit) {
  for (std::size_t first = 0; first < list.entries.size();) {
    const std::string& quantity = list.entries[first].quantity;
    std::size_t last = first;
    while (last < list.entries.size() && list.entries[last].quantity == quantity) ++last;
    visit(quantity, Numbers(list.entries).subspan(first, last - first));
    first = last;
  }
}

std::string list_as_json(const NumberList& list) {
  ordered_json document{{"filter", list.filter}};
  document.update(list.head);
  document["entries"] = ordered_json::array();
  for (const ListedNumber& entry : list.entries) {
    ordered_json row = ordered_json::object();
    if (!entry.quantity.empty()) row["quantity"] = entry.quantity;
    row["indices"] = entry.indices;
    row["value"] = entry.number.value;
    row["radius"] = entry.number.radius;
    row["exact"] = entry.number.exact ? ordered_json(*entry.number.exact) : ordered_json();
    document["entries"].push_back(row);
  }
  return io::json_text(document, 2) + "\n";
}

std::string list_as_csv(const NumberList& list) {
  std::string text = "filter,quantity,index,value,radius,exact\n";
  for (const ListedNumber& entry : list.entries) {
    const auto& [value, radius, exact] = entry.number;
    text += fmt::format("{},{},{},{},{},{}\n", io::csv_field(list.filter),
                        io::csv_field(entry.quantity.empty() ? list.name : entry.quantity),
                        io::csv_field(entry.index), value, radius, exact.value_or(""));
  }
  return text;
}

/// "moment(phi~)" as a name in C++: moment_phi_dual.
std::string array_name(const std::string& quantity) {
  std::string name;
  for (const char c : quantity.empty() ? std::string("values") : quantity) {
    if (c == '~') {
      name += "_dual";
    } else if (c != ')') {
      name += c == '(' ? '_' : c;
    }
  }
  return name;
}

std::string list_as_cpp(const NumberList& list) {
  std::string title = list.name + " of " + list.filter, arrays;
  visit_quantities(list, [&](const std::string& quantity, const Numbers& numbers) {
    std::vector<std::string> decimals;
    for (const ListedNumber& entry : numbers) decimals.push_back(entry.number.value);
    const std::string range = numbers.front().index + " to " + numbers.back().index;
    title += fmt::format(", {}indices {}", quantity.empty() ? "" : quantity + " ", range);
    arrays += header_array(array_name(quantity), decimals);
  });
  return header_opening(title, list.filter) + arrays + header_closing(list.filter);
}

MarkupTable list_as_markup(const NumberList& list) {
  const bool has_several =
      !list.entries.empty() && list.entries.front().quantity != list.entries.back().quantity;
  MarkupTable table{list.name + " of " + list.filter, {"index", "value"}, {}, {}};
  if (has_several) table.columns.insert(table.columns.begin(), "quantity");
  std::vector<certified::DecimalEnclosure> values;
  for (const ListedNumber& entry : list.entries) {
    table.rows.push_back({entry.index, entry.number.value});
    if (has_several)
      table.rows.back().insert(table.rows.back().begin(), MarkupCell(entry.quantity));
    values.push_back(entry.number);
  }
  table.notes.push_back(accuracy_text(values));
  return table;
}

std::string list_as_text(const NumberList& list) {
  std::string text = fmt::format("{} of {}\n\n", list.name, printable(list.filter));
  constexpr std::size_t longest_fraction = 40;
  std::size_t width = 8;
  for (const ListedNumber& entry : list.entries) width = std::max(width, entry.index.size());
  visit_quantities(list, [&](const std::string& quantity, const Numbers& numbers) {
    if (!quantity.empty()) {
      text += fmt::format("{}{}\n", &numbers.front() == list.entries.data() ? "" : "\n", quantity);
    }
    for (const ListedNumber& entry : numbers) {
      const auto& [value, radius, exact] = entry.number;
      text += fmt::format("{:>{}}  {}{}  +- {}", entry.index, width,
                          value.starts_with('-') ? "" : " ", value, radius);
      if (exact && exact->size() <= longest_fraction) text += "  = " + *exact;
      text += "\n";
    }
  });
  return text;
}

}  // namespace

ListedNumber listed(const std::vector<int>& indices, certified::DecimalEnclosure number) {
  std::string text = fmt::format("{}", fmt::join(indices, ", "));
  if (indices.size() > 1) text = "(" + text + ")";
  return {std::move(text), ordered_json(indices), std::move(number)};
}

std::string number_list_output(const NumberList& list, const std::string& format) {
  if (format == "json") return list_as_json(list);
  if (format == "csv") return list_as_csv(list);
  if (format == "cpp") return list_as_cpp(list);
  if (is_markup(format)) return to_markup(list_as_markup(list), format);
  return list_as_text(list);
}

}  // namespace wavecurve::tools
