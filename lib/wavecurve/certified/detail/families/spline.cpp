#include <fmt/format.h>

#include "wavecurve/certified/detail/families/family.hpp"
#include "wavecurve/certified/detail/polynomial.hpp"
#include "wavecurve/filters/autocorrelation.hpp"

namespace wavecurve::certified {

namespace {

constexpr int highest_listed_order = 9;

/// Taps over sqrt 2, exact. The scaling function is the centred B-spline of order D (degree D - 1),
/// the dual that of Cohen, Daubechies and Feauveau (1992, section 6.A) with E zeros at pi:
///   low(w) = cos^D(w/2),  dual(w) = cos^E(w/2) P_K(sin^2(w/2)),  K = (D + E) / 2,
/// both shifted by half a sample where D and E are odd.
struct SplinePair {
  Filter<Rational> synthesis, analysis;
};

SplinePair spline_pair(int order, int dual_order) {
  const int sum_of_orders = order + dual_order;
  SplinePair pair;
  pair.synthesis = {-(order / 2), averaging_polynomial<Rational>(order)};
  const auto dual = averaging_polynomial<Rational>(dual_order) *
                    in_sine_squared(halfband_polynomial(sum_of_orders / 2));
  pair.analysis = {-(dual_order / 2) - (sum_of_orders / 2 - 1), dual};
  return pair;
}

Filter<Ball> times_root_two(const Filter<Rational>& exact) {
  const Ball root_two = sqrt(Ball(2));
  Filter<Ball> filter{exact.first_index, {}};
  for (const Rational& tap : exact.taps) filter.taps.push_back(Ball(tap) * root_two);
  return filter;
}

FilterBank<Rational> two_scale_bank(const std::string& name, const SplinePair& pair) {
  const auto doubled = [](Filter<Rational> filter) {
    for (Rational& tap : filter.taps) tap *= Rational(2);
    return filter;
  };
  return make_filter_bank(name, doubled(pair.analysis), doubled(pair.synthesis));
}

/// alpha of the taps sqrt 2 * exact.
Filter<Rational> scaled_autocorrelation(const Filter<Rational>& exact) {
  Filter<Rational> alpha = autocorrelation(exact);
  for (Rational& value : alpha.taps) value *= Rational(2);
  return alpha;
}

FilterBank<Ball> spline_bank(const std::string& name, int order, int dual_order) {
  const SplinePair pair = spline_pair(order, dual_order);
  auto bank = make_filter_bank(name, times_root_two(pair.analysis), times_root_two(pair.synthesis));
  bank.vanishing_moments = order;
  bank.dual_vanishing_moments = dual_order;
  return bank;
}

std::optional<FilterDefinition> define_spline(std::string_view name) {
  const auto orders = spline_orders(name);
  if (!orders) return std::nullopt;
  FilterDefinition definition;
  definition.name = name;
  definition.bank = [name = definition.name, orders = *orders](long bits) {
    return with_accuracy(bits, [&] { return spline_bank(name, orders.order, orders.dual_order); });
  };
  const SplinePair pair = spline_pair(orders->order, orders->dual_order);
  definition.exact = {scaled_autocorrelation(pair.synthesis),
                      scaled_autocorrelation(pair.analysis)};
  definition.two_scale = two_scale_bank(definition.name, pair);
  definition.two_scale->vanishing_moments = orders->order;
  definition.two_scale->dual_vanishing_moments = orders->dual_order;
  return definition;
}

}  // namespace

Family spline_family() {
  Family family{"bsplineD.E (orders 1 .. 100, D + E even; aliases bior1.1-bior3.9, legall, cdf5.3)",
                {},
                {{"legall", "bspline2.2"}, {"cdf5.3", "bspline2.2"}},
                define_spline,
                false};
  for (int order = 1; order <= highest_listed_order; ++order) {
    for (int dual = 2 - order % 2; dual <= highest_listed_order; dual += 2) {
      family.members.push_back("bspline" + std::to_string(order) + "." + std::to_string(dual));
    }
  }
  for (const auto& [order, highest_dual] : {std::pair(1, 5), {2, 8}, {3, 9}}) {
    for (int dual = 2 - order % 2; dual <= highest_dual; dual += 2) {
      const std::string orders = fmt::format("{}.{}", order, dual);
      family.aliases.emplace_back("bior" + orders, "bspline" + orders);
    }
  }
  return family;
}

}  // namespace wavecurve::certified
