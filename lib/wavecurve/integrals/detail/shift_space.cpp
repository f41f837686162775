#include "wavecurve/integrals/detail/shift_space.hpp"

#include <algorithm>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

ShiftSpace::ShiftSpace(const std::vector<ShiftedFunction>& functions) {
  const ShiftedFunction& fixed = functions.front();
  long box = 1;
  for (std::size_t i = 1; i < functions.size(); ++i) {
    lowest_.push_back(fixed.first - functions[i].last + 1);
    sizes_.push_back(fixed.last - functions[i].first - lowest_.back());
    box *= std::max(sizes_.back(), 1);
    check_between("number of shifts of a product", box, 1, most_integrals);
  }
  unknowns_.assign(static_cast<std::size_t>(box), -1);
  Tuple y{};
  std::copy(lowest_.begin(), lowest_.end(), y.begin());
  for (std::size_t place = 0; place < unknowns_.size(); ++place) {
    if (supports_meet(functions, y)) number_tuple(functions, y);
    // The next tuple, in the order of the box.
    for (std::size_t i = dimensions(); i-- > 0;) {
      if (++y[i] < lowest_[i] + sizes_[i]) break;
      y[i] = lowest_[i];
    }
  }
}

int ShiftSpace::largest_multiplicity() const {
  return *std::max_element(multiplicities_.begin(), multiplicities_.end());
}

int& ShiftSpace::entry(const Tuple& y) {
  std::size_t place = 0;
  for (std::size_t i = 0; i < lowest_.size(); ++i) {
    place =
        place * static_cast<std::size_t>(sizes_[i]) + static_cast<std::size_t>(y[i] - lowest_[i]);
  }
  return unknowns_[place];
}

bool ShiftSpace::supports_meet(const std::vector<ShiftedFunction>& functions,
                               const Tuple& y) const {
  int first = functions.front().first, last = functions.front().last;
  for (std::size_t i = 0; i < dimensions(); ++i) {
    first = std::max(first, functions[i + 1].first + y[i]);
    last = std::min(last, functions[i + 1].last + y[i]);
  }
  return first < last;
}

void ShiftSpace::number_tuple(const std::vector<ShiftedFunction>& functions, const Tuple& y) {
  const Tuple least = canonical(functions, y);
  int& unknown = entry(least);
  if (unknown < 0) {
    unknown = size();
    check_between("number of unknown integrals of the two-scale system", unknown + 1L, 1,
                  most_unknowns);
    representatives_.push_back(least);
    multiplicities_.push_back(0);
  }
  ++multiplicities_[static_cast<std::size_t>(unknown)];
  entry(y) = unknown;
}

/// The tuple in which functions of one kind stand in the order of their shifts.
ShiftSpace::Tuple ShiftSpace::canonical(const std::vector<ShiftedFunction>& functions,
                                        const Tuple& y) const {
  std::array<int, most_factors> places{};
  std::copy_n(y.begin(), dimensions(), places.begin() + 1);
  for (std::size_t i = 1; i < functions.size(); ++i) {  // sorts by insertion within each kind
    for (std::size_t later = i, j = i; j-- > 0;) {
      if (functions[j].kind != functions[later].kind) continue;
      if (places[j] <= places[later]) break;
      std::swap(places[j], places[later]);
      later = j;
    }
  }
  Tuple sorted{};
  for (std::size_t i = 0; i < dimensions(); ++i) sorted[i] = places[i + 1] - places[0];
  return sorted;
}

}  // namespace wavecurve
