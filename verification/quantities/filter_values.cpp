#include "verification/quantities/filter_values.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
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
  const bool wants_pair = bare.factors.size() == 3;
  const bool wants_point = bare.family->name == "value";
  if (index.is_pair == wants_pair && (wants_point || wants_pair || index.is_integer())) return;
  throw std::domain_error(fmt::format("the index {} of {} must be {}", index.text(),
                                      to_string(bare),
                                      wants_pair    ? "a pair of integers l, m"
                                      : wants_point ? "an integer or a dyadic point"
                                                    : "an integer"));
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
  Sequence computed =
      bare.family->compute(definition_, bare.factors, sample_for(bare, sample), bits);
  return sequences_.emplace(key, std::move(computed)).first->second;
}

TrueValue FilterValues::bare_value(const Quantity& bare, const EntryIndex& index) {
  require_kind_of_index(bare, index);
  const Sequence& known = sequence(bare, index, least_bits);
  const auto [least, most] = std::minmax(index.first, index.is_pair ? index.second : index.first);
  if (least < known.first || most > known.last) {
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
    const EntryIndex index = bare.factors.size() == 3 ? EntryIndex::pair(l, 0) : EntryIndex(l);
    const TrueValue value = bare_value(bare, index);
    if (!value.is_exactly_zero()) return value;
  }
  throw std::domain_error("all entries of " + to_string(bare) + " vanish");
}

TrueValue FilterValues::value(const Quantity& quantity, const EntryIndex& index) {
  const Quantity bare = quantity.bare();
  TrueValue result = bare_value(bare, index);
  if (quantity.divided_by_first) {
    const bool is_first = !index.is_pair && index.first == 0 && !result.is_exactly_zero();
    result = is_first ? TrueValue{Rational(1), {}} : quotient(result, first_value(bare));
  }
  result = times_root_two(result, quantity.half_powers);
  return quantity.negated ? negative(result) : result;
}

std::pair<int, int> FilterValues::index_range(const Quantity& quantity) {
  const Quantity bare = quantity.bare();
  const Sequence& known =
      sequence(bare, bare.factors.size() == 3 ? EntryIndex::pair(0, 0) : EntryIndex(0), least_bits);
  return {known.first, known.last};
}

certified::FilterDefinition find_table_filter(const std::string& name) {
  return io::load_filter(name);
}

}  // namespace wavecurve::verification
