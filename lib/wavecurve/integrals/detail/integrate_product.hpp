#pragma once

#include <algorithm>
#include <vector>

#include "wavecurve/integrals/detail/product_expansion.hpp"
#include "wavecurve/integrals/periodic.hpp"

namespace wavecurve {

// How an integral of a product is put together, for any scalar; product_system.hpp and
// product_expansion.hpp have the formulas. Who calls says how the systems are solved.

/// The refinable functions that a product is made of, the box of an interval first.
template <class Scalar>
struct RefinableProduct {
  std::vector<Filter<Scalar>> masks;
  std::vector<ShiftedFunction> functions;
};

template <class Scalar>
RefinableProduct<Scalar> refinable_product(const TwoScaleSides<Scalar>& sides,
                                           const ProductIntegral& integral) {
  RefinableProduct<Scalar> product;
  if (integral.interval) {
    product.masks.push_back({0, {Scalar(1), Scalar(1)}});
    product.functions.push_back({0, 1, -1});
  }
  for (const IntegralFactor& factor : integral.factors) {
    const BasisFunction& f = factor.function;
    Filter<Scalar> mask = without_zeros_at_pi(sides.of(f).low, f.derivative);
    const int kind = 2 * f.derivative + (f.dual ? 1 : 0);
    product.functions.push_back({mask.first_index, mask.last_index(), kind});
    product.masks.push_back(std::move(mask));
  }
  // x^p belongs to the first function, which may not be exchanged with others then.
  if (integral.power > 0) product.functions.front().kind = -1;
  return product;
}

/// D_0 .. D_p, by solve(space, A_0, p, right-hand side) of (I - 2^-p A_0 [+ u 1^T if p = 0]) D =
/// right.
template <class Scalar, class Solve>
std::vector<std::vector<Scalar>> solve_systems(const RefinableProduct<Scalar>& product,
                                               const ShiftSpace& space, int power, Solve solve) {
  const auto n = static_cast<std::size_t>(space.size());
  std::vector<ProductMask<Scalar>> masks;
  std::vector<std::vector<Scalar>> d;
  for (int p = 0; p <= power; ++p) {
    masks.push_back(product_mask(product.masks, p));
    std::vector<Scalar> right(
        n, p == 0 ? Scalar(1) / Scalar(static_cast<long>(tuples_rounded_up(space))) : Scalar(0));
    Scalar binomial = power_of_two<Scalar>(-p);
    for (int q = 0; q < p; ++q) {
      const std::vector<Scalar> part =
          apply(space, masks[static_cast<std::size_t>(p - q)], d[static_cast<std::size_t>(q)]);
      for (std::size_t i = 0; i < n; ++i) add_product(right[i], binomial, part[i]);
      binomial *= Scalar(p - q) / Scalar(q + 1);
    }
    d.push_back(solve(space, masks.front(), p, right));
  }
  return d;
}

/// sum += scale term, on the smallest box that holds both.
template <class Scalar>
void add_scaled(ShiftTensor<Scalar>& sum, const ShiftTensor<Scalar>& term, const Scalar& scale) {
  std::vector<int> first, sizes;
  for (std::size_t i = 0; i < term.dimensions(); ++i) {
    first.push_back(std::min(sum.first[i], term.first[i]));
    sizes.push_back(std::max(sum.last(i), term.last(i)) - first.back() + 1);
  }
  ShiftTensor<Scalar> result(first, sizes);
  for (std::size_t place = 0; place < result.values.size(); ++place) {
    const std::vector<int> indices = result.indices(place);
    result.values[place] = sum.at(indices);
    add_product(result.values[place], scale, term.at(indices));
  }
  sum = std::move(result);
}

template <class Scalar, class Solve>
ShiftTensor<Scalar> integrate_product(const TwoScaleSides<Scalar>& sides,
                                      const ProductIntegral& integral, Solve solve);

/// The integral of a product whose factor i has more derivatives than (D) takes, by parts:
///   int x^p f'(2^j x) g(x) dx = -2^-j int f(2^j x) (x^p g(x))' dx.
template <class Scalar, class Solve>
ShiftTensor<Scalar> integrate_by_parts(const TwoScaleSides<Scalar>& sides, ProductIntegral integral,
                                       std::size_t i, Solve solve) {
  --integral.factors[i].function.derivative;
  const int level = integral.factors[i].level;
  std::vector<std::pair<ProductIntegral, Scalar>> terms;
  if (integral.power > 0) {
    terms.emplace_back(integral, Scalar(-integral.power) * power_of_two<Scalar>(-level));
    --terms.back().first.power;
  }
  for (std::size_t j = 0; j < integral.factors.size(); ++j) {
    if (j == i) continue;
    terms.emplace_back(integral, -power_of_two<Scalar>(integral.factors[j].level - level));
    ++terms.back().first.factors[j].function.derivative;
  }
  ShiftTensor<Scalar> sum = integrate_product(sides, terms.front().first, solve);
  for (Scalar& value : sum.values) value *= terms.front().second;
  for (std::size_t term = 1; term < terms.size(); ++term) {
    add_scaled(sum, integrate_product(sides, terms[term].first, solve), terms[term].second);
  }
  return sum;
}

template <class Scalar, class Solve>
ShiftTensor<Scalar> integrate_product(const TwoScaleSides<Scalar>& sides,
                                      const ProductIntegral& integral, Solve solve) {
  const auto& [factors, power, interval, period] = integral;
  // A function without a zero left may be a point mass, as hat'' is; by parts it is a function
  // again.
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const BasisFunction& f = factors[i].function;
    const bool has_zeros = f.derivative == 0 || f.derivative < sides.of(f).zeros;
    if (!has_zeros && factors.size() > 1) return integrate_by_parts(sides, integral, i, solve);
  }
  const RefinableProduct<Scalar> product = refinable_product(sides, integral);
  const ShiftSpace space(product.functions);
  const auto d = solve_systems(product, space, power, solve);

  int finest = interval ? interval->level : 0;
  for (const IntegralFactor& factor : factors) {
    finest = std::max(finest, factor.level + (factor.function.wavelet ? 1 : 0));
  }
  const auto expansion_of = [&](const IntegralFactor& factor) {
    return expansion(sides, factor.function, finest - factor.level);
  };
  std::size_t next = 0;  // the first factor that has a dimension of its own
  Filter<Scalar> first;
  if (interval) {
    const int scale = 1 << (finest - interval->level);
    first.first_index = interval->first * scale;
    first.taps.assign(static_cast<std::size_t>((interval->last - interval->first) * scale),
                      Scalar(1));
  } else {
    first = expansion_of(factors[next++]);
  }
  ShiftTensor<Scalar> result = expand_first(space, d, first);
  for (std::size_t dimension = 0; next < factors.size(); ++next) {
    const IntegralFactor& factor = factors[next];
    result = expand_along(result, dimension, expansion_of(factor), 1 << (finest - factor.level),
                          factor.shifted);
    if (factor.shifted) ++dimension;
  }
  const Scalar scale = power_of_two<Scalar>(-finest * (power + 1));
  for (Scalar& value : result.values) value *= scale;
  return period ? periodized(result, *period) : result;
}

}  // namespace wavecurve
