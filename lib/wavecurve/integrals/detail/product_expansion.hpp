#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/filter.hpp"
#include "wavecurve/integrals/detail/product_system.hpp"
#include "wavecurve/integrals/shift_tensor.hpp"

namespace wavecurve {

// From the integrals D_q of refinable functions to those that are asked for. At the finest level J,
//   f_i(2^j_i x - l) = sum_k E^i_k s_i(2^J x - 2^(J-j_i) l - k),
// E^i being two-scale filters one after the other, and the differences of (D) in
// product_system.hpp; an interval is such a factor too, a sum of boxes. So
//   I_p(l_2, ..) = 2^(-J (p+1)) sum_{k_1 .. k_k} prod_i E^i_{k_i} sum_q binomial(p, q) k_1^(p-q)
//                  D_q(.., 2^(J-j_i) l_i + k_i - k_1, ..),
// which is done one k_i after the other.

/// The two sides of a filter bank in the normalisation of the two-scale relations, sum a_n = 2, and
/// the zeros of the low-pass filters at z = -1.
template <class Scalar>
struct TwoScaleSides {
  struct Side {
    Filter<Scalar> low, high;
    int zeros = 0;
  };
  Side synthesis, analysis;
  const Side& of(const BasisFunction& f) const { return f.dual ? analysis : synthesis; }
};

template <class Scalar>
Scalar power_of_two(int exponent) {
  Scalar result(1);
  for (int i = 0; i < std::abs(exponent); ++i) result *= Scalar(2);
  return exponent < 0 ? Scalar(1) / result : result;
}

/// sum_k a_k b_{n - stride k}.
template <class Scalar>
Filter<Scalar> composed(const Filter<Scalar>& a, const Filter<Scalar>& b, int stride) {
  Filter<Scalar> result{stride * a.first_index + b.first_index, {}};
  result.taps.assign(static_cast<std::size_t>(stride * (a.size() - 1) + b.size()), Scalar(0));
  for (std::size_t k = 0; k < a.taps.size(); ++k) {
    for (std::size_t n = 0; n < b.taps.size(); ++n) {
      add_product(result.taps[static_cast<std::size_t>(stride) * k + n], a.taps[k], b.taps[n]);
    }
  }
  return result;
}

/// E of a function, `steps` levels below its own.
template <class Scalar>
Filter<Scalar> expansion(const TwoScaleSides<Scalar>& sides, const BasisFunction& f, int steps) {
  const auto& side = sides.of(f);
  Filter<Scalar> result{0, {power_of_two<Scalar>(f.derivative * steps)}};
  for (int step = 0; step < steps; ++step) {
    result = composed(result, step == 0 && f.wavelet ? side.high : side.low, 2);
  }
  const Filter<Scalar> difference{0, {Scalar(1), Scalar(-1)}};
  for (int d = 0; d < f.derivative; ++d) result = composed(result, difference, 1);
  return result;
}

/// sum += scale times the D whose unknowns are given, moved by k in every dimension.
template <class Scalar>
void add_moved(ShiftTensor<Scalar>& sum, const ShiftSpace& space, const std::vector<Scalar>& d,
               const Scalar& scale, int k) {
  const std::vector<int>& unknowns = space.unknowns();
  const std::vector<int>& sizes = space.sizes();
  for (std::size_t place = 0; place < unknowns.size(); ++place) {
    if (unknowns[place] < 0) continue;
    std::size_t target = 0, stride = 1, rest = place;
    for (std::size_t i = sizes.size(); i-- > 0;) {
      const int index = static_cast<int>(rest % static_cast<std::size_t>(sizes[i]));
      rest /= static_cast<std::size_t>(sizes[i]);
      target += stride * static_cast<std::size_t>(index + space.lowest()[i] + k - sum.first[i]);
      stride *= static_cast<std::size_t>(sum.sizes[i]);
    }
    add_product(sum.values[target], scale, d[static_cast<std::size_t>(unknowns[place])]);
  }
}

/// The sum over k_1: sum_q binomial(p, q) sum_k E_k k^(p-q) D_q(y - k), p the highest q.
template <class Scalar>
ShiftTensor<Scalar> expand_first(const ShiftSpace& space, const std::vector<std::vector<Scalar>>& d,
                                 const Filter<Scalar>& e) {
  std::vector<int> first, sizes;
  long count = 1;
  for (std::size_t i = 0; i < space.dimensions(); ++i) {
    first.push_back(space.lowest()[i] + e.first_index);
    sizes.push_back(space.sizes()[i] + e.size() - 1);
    count *= sizes.back();
    check_between("number of integrals on the way to the result", count, 1, most_integrals);
  }
  ShiftTensor<Scalar> result(std::move(first), std::move(sizes));
  const int p = static_cast<int>(d.size()) - 1;
  for (int k = e.first_index; k <= e.last_index(); ++k) {
    Scalar weight = e[k];  // E_k k^(p-q) binomial(p, q), from q = p downwards
    for (int q = p; q >= 0; --q) {
      add_moved(result, space, d[static_cast<std::size_t>(q)], weight, k);
      weight *= Scalar(k) * Scalar(q) / Scalar(p - q + 1);
    }
  }
  return result;
}

inline int floor_quotient(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

/// The sum over k_i in one dimension: sum_k E_k T(.., stride l + k, ..); for l = 0 alone, without
/// the dimension, if the factor is not shifted.
template <class Scalar>
ShiftTensor<Scalar> expand_along(const ShiftTensor<Scalar>& t, std::size_t dimension,
                                 const Filter<Scalar>& e, int stride, bool shifted) {
  const int first = shifted ? -floor_quotient(e.last_index() - t.first[dimension], stride) : 0;
  const int last = shifted ? floor_quotient(t.last(dimension) - e.first_index, stride) : 0;
  ShiftTensor<Scalar> sum(t.first, [&] {
    std::vector<int> sizes = t.sizes;
    sizes[dimension] = std::max(last - first + 1, 0);
    return sizes;
  }());
  sum.first[dimension] = first;
  std::size_t outer = 1, inner = 1;
  for (std::size_t i = 0; i < dimension; ++i) outer *= static_cast<std::size_t>(t.sizes[i]);
  for (std::size_t i = dimension + 1; i < t.dimensions(); ++i) {
    inner *= static_cast<std::size_t>(t.sizes[i]);
  }
  const auto rows = static_cast<std::size_t>(t.sizes[dimension]);
  const auto new_rows = static_cast<std::size_t>(sum.sizes[dimension]);
  for (std::size_t block = 0; block < outer; ++block) {
    for (int l = first; l <= last; ++l) {
      Scalar* const to =
          &sum.values[(block * new_rows + static_cast<std::size_t>(l - first)) * inner];
      for (int k = e.first_index; k <= e.last_index(); ++k) {
        const int row = stride * l + k;
        if (row < t.first[dimension] || row > t.last(dimension)) continue;
        const auto place = static_cast<std::size_t>(row - t.first[dimension]);
        const Scalar* const from = &t.values[(block * rows + place) * inner];
        const Scalar weight = e[k];
        for (std::size_t i = 0; i < inner; ++i) add_product(to[i], weight, from[i]);
      }
    }
  }
  if (!shifted) {
    sum.first.erase(sum.first.begin() + static_cast<std::ptrdiff_t>(dimension));
    sum.sizes.erase(sum.sizes.begin() + static_cast<std::ptrdiff_t>(dimension));
  }
  return sum;
}

}  // namespace wavecurve
