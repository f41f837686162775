#include "wavecurve/operators/detail/circulant_product.hpp"

#include <type_traits>

#include "wavecurve/elementary/detail/highway_targets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "wavecurve/operators/detail/circulant_product.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace wavecurve::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Index = Eigen::Index;

/// `at_once` vectors of outputs. Where the compiler knows the number of weights (0: it does not), the
/// loops are unrolled, and a vector of inputs is loaded once for all weights that need it: 24 loads
/// instead of 52 for seven weights and four vectors.
template <int known, int at_once, class D>
HWY_INLINE void multiply(D d, const double* weights, int size, bool antisymmetric,
                         const double* HWY_RESTRICT x, double* HWY_RESTRICT out) {
  const Index lanes = static_cast<Index>(hn::Lanes(d));
  const int n = known == 0 ? size : known;
  hn::Vec<D> sum[at_once];
  const auto centre = hn::Set(d, weights[0]);
  for (int i = 0; i < at_once; ++i) sum[i] = hn::Mul(centre, hn::LoadU(d, x + i * lanes));
#pragma GCC unroll 16
  for (int l = 1; l < n; ++l) {
    const auto weight = hn::Set(d, weights[l]);
#pragma GCC unroll 16
    for (int i = 0; i < at_once; ++i) {
      const auto before = hn::LoadU(d, x + i * lanes - l), after = hn::LoadU(d, x + i * lanes + l);
      const auto both = antisymmetric ? hn::Sub(before, after) : hn::Add(before, after);
      sum[i] = hn::Add(sum[i], hn::Mul(weight, both));
    }
  }
  for (int i = 0; i < at_once; ++i) hn::StoreU(sum[i], d, out + i * lanes);
}

/// 32 bytes: of a wider vector, nearly every load lies across two cache lines.
using Tag = hn::CappedTag<double, 4>;

template <int known>
HWY_INLINE void multiply_all(const std::vector<double>& weights, bool antisymmetric,
                             const double* x, Index count, double* out) {
  const int size = static_cast<int>(weights.size());
  Index i = 0;
  const auto advance = [&](auto d, auto at_once) HWY_ATTR {
    const Index step = at_once * static_cast<Index>(hn::Lanes(d));
    for (; i + step <= count; i += step) {
      multiply<known, at_once>(d, weights.data(), size, antisymmetric, x + i, out + i);
    }
  };
  advance(Tag(), std::integral_constant<int, 4>());
  advance(hn::CappedTag<double, 1>(), std::integral_constant<int, 1>());
}

void product(const std::vector<double>& weights, int sign, const double* x, Index count,
             double* out) {
  switch (sign > 0 ? weights.size() : 0) {  // those of Daubechies' filters of order 2 to 5
    case 3:
      return multiply_all<3>(weights, false, x, count, out);
    case 5:
      return multiply_all<5>(weights, false, x, count, out);
    case 7:
      return multiply_all<7>(weights, false, x, count, out);
    case 9:
      return multiply_all<9>(weights, false, x, count, out);
    default:
      return multiply_all<0>(weights, sign < 0, x, count, out);
  }
}

}  // namespace wavecurve::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wavecurve {

HWY_EXPORT(product);

void circulant_product(const std::vector<double>& weights, int sign, const double* x,
                       Eigen::Index count, double* out) {
  HWY_DYNAMIC_DISPATCH(product)(weights, sign, x, count, out);
}

}  // namespace wavecurve
#endif
