#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/certified/basis_function.hpp"
#include "wavecurve/certified/integrals/product_integrals.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/certified/sobolev_exponent.hpp"
#include "wavecurve/integrals/detail/needed_exponent.hpp"

namespace wavecurve::certified {

namespace {

constexpr int shown_digits = 4;

std::string exponent_text(const Ball& exponent) {
  return round_to_digits(exponent, shown_digits).value_or("not known well enough");
}

/// (E) for exponents of several functions.
void require_sums(const FilterDefinition& definition, const ProductIntegral& integral,
                  std::vector<std::pair<Ball, std::string>> exponents) {
  std::sort(exponents.begin(), exponents.end(),
            [](const auto& a, const auto& b) { return a.first.to_double() < b.first.to_double(); });
  Ball sum(0);
  std::string names;
  for (std::size_t m = 1; m <= exponents.size(); ++m) {
    sum += exponents[m - 1].first;
    names += (m == 1 ? "" : ", ") + exponents[m - 1].second;
    const Rational needed(static_cast<long>(m) - 2, 2);
    if (m < 2 || certainly_less(Ball(needed), sum)) continue;
    throw std::domain_error(fmt::format(
        "filter {} is not smooth enough for {}: the Sobolev exponents of {} add up to {}, but must "
        "exceed {}{}",
        definition.name, name_of(integral), names, exponent_text(sum), round_to_decimals(needed, 1),
        m == 2 ? "" : " (a sufficient condition)"));
  }
}

}  // namespace

void require_existence(const FilterDefinition& definition, const ProductIntegral& integral) {
  const auto& [factors, power, interval, period] = integral;
  if (factors.size() == 1 && !interval) return;  // moments always exist
  bool has_dual = false, has_primal = false;
  for (const IntegralFactor& factor : factors) {
    (factor.function.dual ? has_dual : has_primal) = true;
  }
  const WorkingPrecision precision(128);
  if (has_dual && has_primal) {
    std::vector<std::pair<Ball, std::string>> exponents;
    for (const IntegralFactor& factor : factors) {
      exponents.emplace_back(sobolev_exponent(definition, factor.function),
                             name_of(factor.function));
    }
    if (interval) exponents.emplace_back(Ball(Rational(1, 2)), "the interval");
    require_sums(definition, integral, std::move(exponents));
    return;
  }
  const FilterDefinition side = has_dual ? dual(definition) : definition;
  const auto [numerator, denominator] = needed_exponent(integral);
  const Rational needed(numerator, denominator);
  if (is_proved_smoother(side, needed)) return;
  throw std::domain_error(fmt::format(
      "filter {} is not smooth enough for {}: its Sobolev exponent is {}, but it must exceed {}{}",
      definition.name, name_of(integral), exponent_text(sobolev_exponent(side)),
      round_to_digits(needed, shown_digits),
      factors.size() == 2 && !interval ? "" : " (a sufficient condition)"));
}

}  // namespace wavecurve::certified
