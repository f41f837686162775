#include "verification/checker/judge_doubles.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "wavecurve/certified/rounding.hpp"

#include "verification/prints/true_value.hpp"
#include "verification/quantities/convention.hpp"
#include "verification/quantities/filter_values.hpp"

namespace wavecurve::verification {

namespace {

bool is_nearest(const TrueValue& value, double number) {
  return decide(value, [&](const certified::Ball& enclosure) {
           const auto nearest = certified::round_to_double(enclosure);
           if (!nearest) return Decision::undecided;
           return *nearest == number ? Decision::yes : Decision::no;
         }) == Decision::yes;
}

class Doubles {
 public:
  explicit Doubles(const CheckedTable& table) : table_(table) {}

  bool is_certified(const PublishedEntry& entry) {
    FilterValues& filter = filter_of(entry.filter);
    const auto column = std::ranges::find_if(table_.columns, [&](const CheckedColumn& c) {
      return c.filter == filter.name() && c.quantity == entry.quantity;
    });
    if (column == table_.columns.end()) return false;
    const TrueValue value =
        conventional_value(filter, entry.quantity, column->convention, entry.index);
    return is_nearest(value, entry.number.to_double());
  }

 private:
  FilterValues& filter_of(const std::string& name) {
    const auto found = filters_.find(name);
    if (found != filters_.end()) return found->second;
    return filters_.emplace(name, FilterValues(find_table_filter(name))).first->second;
  }

  const CheckedTable& table_;
  std::map<std::string, FilterValues> filters_;
};

}  // namespace

CheckedTable judged_as_doubles(CheckedTable table) {
  Doubles doubles(table);
  for (CheckedRow& row : table.rows) {
    if (row.verdict == PrintVerdict::certified || !doubles.is_certified(row.entry)) continue;
    row.verdict = PrintVerdict::certified;
    row.detail = "the double nearest to the true value";
    row.route.clear();
    row.departure.reset();
  }
  return table;
}

}  // namespace wavecurve::verification
