#include "verification/quantities/filter_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "wavecurve/io/load_filter.hpp"

namespace wavecurve::verification {

using certified::Ball;
using certified::Rational;
using certified::WorkingPrecision;

namespace {

constexpr long least_bits = 128;
constexpr long spare_bits = 32;

/// What distinguishes one computed sequence from another: how fine the points are, or how many
/// moments there are, rounded up so that neighbours share one.
long detail_of(const Quantity& bare, const EntryIndex& sample) {
  constexpr long moments_at_once = 10;
  if (bare.family->name == "value") return sample.dyadic_level();
  if (bare.family->name != "moment") return 0;
  const long p = std::abs(std::lround(sample.first));
  return std::min((p / moments_at_once + 1) * moments_at_once, std::max(p, 100L));
}

EntryIndex sample_for(const Quantity& bare, const EntryIndex& index) {
  if (bare.family->name != "moment") return index;
  return EntryIndex(static_cast<int>(detail_of(bare, index)));
}

void require_kind_of_index(const Quantity& bare, const EntryIndex& index) {
  constexpr std::array<std::string_view, 3> integers{"an integer", "a pair of integers l, m",
                                                     "three integers l, m, n"};
  constexpr std::array<std::string_view, 3> points{"an integer or a dyadic point",
                                                   "a point x and an integer l",
                                                   "a point x and two integers l, m"};
  const int count = bare.index_count();
  const bool wants_point = bare.family->name == "value" || bare.up_to_x;
  const int finest = !wants_point   ? 0
                     : bare.up_to_x ? highest_integral_level
                                    : index.dyadic_level();
  if (index.count == count && index.dyadic_level() <= finest) return;
  const auto kind = static_cast<std::size_t>(count - 1);
  throw std::domain_error(fmt::format("the index {} of {} must be {}", index.text(),
                                      to_string(bare),
                                      wants_point ? points[kind] : integers[kind]));
}

/// l, (l, 0) or (l, 0, 0), as the quantity has it.
EntryIndex index_beside_zeros(const Quantity& bare, int l) {
  constexpr std::array<int, most_indices - 1> zeros{};
  return EntryIndex::tuple(
      l, std::span(zeros).first(static_cast<std::size_t>(bare.index_count() - 1)));
}

/// A factor of the square root of two, which is exact for even powers.
TrueValue times_root_two(const TrueValue& value, int half_powers) {
  if (half_powers == 0) return value;
  const Rational whole = Rational::power_of_two((half_powers - (half_powers & 1)) / 2);
  if (value.exact && (half_powers % 2 == 0 || value.exact->is_zero())) {
    return {*value.exact * whole, {}};
  }
  const bool root = half_powers % 2 != 0;
  return {std::nullopt, [value, whole, root](long bits) {
            const Ball known = value.exact ? Ball(*value.exact) : value.enclosure(bits);
            const WorkingPrecision precision(bits + spare_bits);
            return root ? known * sqrt(Ball(2)) * Ball(whole) : known * Ball(whole);
          }};
}

TrueValue negative(const TrueValue& value) {
  if (value.exact) return {-*value.exact, {}};
  return {std::nullopt, [value](long bits) { return -value.enclosure(bits); }};
}

TrueValue quotient(const TrueValue& value, const TrueValue& divisor) {
  if (value.exact && value.exact->is_zero()) return value;
  if (value.exact && divisor.exact) return {*value.exact / *divisor.exact, {}};
  return {std::nullopt, [value, divisor](long bits) {
            const Ball a = value.exact ? Ball(*value.exact) : value.enclosure(bits);
            const Ball b = divisor.exact ? Ball(*divisor.exact) : divisor.enclosure(bits);
            const WorkingPrecision precision(bits + spare_bits);
            return a / b;
          }};
}

}  // namespace

FilterValues::FilterValues(certified::FilterDefinition definition)
    : definition_(std::move(definition)) {
  const FilterBank<Ball> bank = definition_.bank(least_bits);
  orthonormal_ = bank.is_orthonormal();
  first_tap_ = bank.synthesis_low.first_index;
  number_of_taps_ = bank.synthesis_low.size();
}

const Sequence& FilterValues::sequence(const Quantity& bare, const EntryIndex& sample, long bits) {
  const std::tuple key(to_string(bare), detail_of(bare, sample), bits);
  // Finer points, or more moments, hold the coarser and the fewer.
  for (auto known = sequences_.lower_bound(key);
       known != sequences_.end() && std::get<0>(known->first) == std::get<0>(key); ++known) {
    if (std::get<2>(known->first) == bits) return known->second;
  }
  Sequence computed = bare.family->compute(definition_, bare, sample_for(bare, sample), bits);
  return sequences_.emplace(key, std::move(computed)).first->second;
}

TrueValue FilterValues::bare_value(const Quantity& bare, const EntryIndex& index) {
  require_kind_of_index(bare, index);
  const Sequence& known = sequence(bare, index, least_bits);
  const double all[] = {index.first, double(index.second), double(index.third)};
  const auto [least, most] = std::minmax_element(all, all + index.count);
  if (*least < known.first || *most > known.last) {
    throw std::domain_error(fmt::format("the index {} of {} is out of range: {} has {} to {}",
                                        index.text(), to_string(bare), definition_.name,
                                        known.first, known.last));
  }
  if (known.exact) {
    if (const auto exact = known.exact(index)) return {*exact, {}};
  }
  if (const auto exact = known.enclosure(index).exact_value()) return {*exact, {}};
  return {std::nullopt,
          [this, bare, index](long bits) { return sequence(bare, index, bits).enclosure(index); }};
}

/// The entry of the smallest index >= 0 that does not vanish.
TrueValue FilterValues::first_value(const Quantity& bare) {
  const auto [first, last] = index_range(bare);
  for (int l = std::max(first, 0); l <= last; ++l) {
    const TrueValue value = bare_value(bare, index_beside_zeros(bare, l));
    if (!value.is_exactly_zero()) return value;
  }
  throw std::domain_error("all entries of " + to_string(bare) + " vanish");
}

TrueValue FilterValues::value(const Quantity& quantity, const EntryIndex& index) {
  const Quantity bare = quantity.bare();
  TrueValue result = bare_value(bare, index);
  if (quantity.divided_by_first) {
    const bool is_first = !index.is_tuple() && index.first == 0 && !result.is_exactly_zero();
    result = is_first ? TrueValue{Rational(1), {}} : quotient(result, first_value(bare));
  }
  result = times_root_two(result, quantity.half_powers);
  return quantity.negated ? negative(result) : result;
}

std::pair<int, int> FilterValues::index_range(const Quantity& quantity) {
  const Quantity bare = quantity.bare();
  const Sequence& known = sequence(bare, index_beside_zeros(bare, 0), least_bits);
  return {known.first, known.last};
}

certified::FilterDefinition find_table_filter(const std::string& name) {
  return io::load_filter(name);
}

}  // namespace wavecurve::verification
