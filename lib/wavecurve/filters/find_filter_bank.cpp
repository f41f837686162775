#include "wavecurve/filters/find_filter_bank.hpp"

#include "wavecurve/filters/detail/filter_name.hpp"
#include "wavecurve/filters/detail/spline_filter.hpp"
#include "wavecurve/filters/filter_tables.hpp"

namespace wavecurve {

namespace {

template <class Scalar>
Filter<Scalar> slice(int first_index, std::size_t offset, std::size_t size) {
  const auto taps = filter_table_taps<Scalar>().subspan(offset, size);
  return {first_index, {taps.begin(), taps.end()}};
}

template <class Scalar>
FilterBank<Scalar> bank_of(const FilterTableRow& row) {
  auto bank = make_filter_bank(
      std::string(row.name),
      slice<Scalar>(row.analysis_first_index, row.analysis_offset, row.analysis_size),
      slice<Scalar>(row.synthesis_first_index, row.synthesis_offset, row.synthesis_size));
  bank.vanishing_moments = row.vanishing_moments;
  bank.dual_vanishing_moments = row.dual_vanishing_moments;
  bank.sobolev_exponent = row.sobolev_exponent;
  return bank;
}

/// "db1-db38" and the like: of each family the first name and the last.
std::vector<std::string> known_names() {
  std::vector<std::string> names{"bsplineD.E"};
  std::string_view family;
  for (const FilterTableRow& row : filter_table_rows()) {
    const std::string_view letters = row.name.substr(0, row.name.find_first_of("0123456789"));
    if (letters != family) {
      names.emplace_back(row.name);
      family = letters;
    } else {
      std::string& range = names.back();
      range = range.substr(0, range.find('-')) + "-" + std::string(row.name);
    }
  }
  return names;
}

}  // namespace

template <class Scalar>
FilterBank<Scalar> find_filter_bank(std::string_view name) {
  std::string_view canonical = name;
  for (const auto& [alias, target] : filter_aliases()) {
    if (alias == name) canonical = target;
  }
  for (const FilterTableRow& row : filter_table_rows()) {
    if (row.name == canonical) return bank_of<Scalar>(row);
  }
  if (auto bank = spline_filter_bank<Scalar>(canonical)) return *bank;
  refuse_filter_name(name, known_names());
}

template FilterBank<double> find_filter_bank(std::string_view);
template FilterBank<float> find_filter_bank(std::string_view);

}  // namespace wavecurve
