#pragma once

#include <array>
#include <vector>

#include "wavecurve/filters/filter.hpp"
#include "wavecurve/integrals/detail/shift_space.hpp"

namespace wavecurve {

// The two-scale system of the integrals of products of refinable functions, for any scalar.
//
// s_i(x) = sum_n a^i_n s_i(2x - n), sum_n a^i_n = 2, int s_i = 1. With
//   D_p(y) = int x^p s_1(x) s_2(x - y_2) .. s_k(x - y_k) dx,
//   A_m(s) = 1/2 sum_n n^m a^1_n a^2_{n+s_2} .. a^k_{n+s_k},
//   (A_m D)(y) = sum_s A_m(s) D(2y + s),
// the two-scale relations and x = (t + n)/2 under the integral say
//   D_p = 2^-p sum_{q<=p} binomial(p, q) A_{p-q} D_q.                                     (R)
// p = 0: D_0 = A_0 D_0 is homogeneous. All but one of the functions have a zero at z = -1 in their
// mask, so that their shifts add up to 1, whence
//   sum_y D_0(y) = 1                                                                      (S)
// and 1^T A_0 = 1^T. Every D_0 that obeys both obeys (I - A_0 + u 1^T) D_0 = u for any u; if that
// matrix is regular, it has no other solution. p > 0: (I - 2^-p A_0) D_p is known from the powers
// below.
//
// Derivatives need no system of their own: where the mask a(z) has d zeros at z = -1,
//   s^(d) = Delta^d s_d,   (Delta f)(x) = f(x) - f(x - 1),   s_d of mask (2/(1+z))^d a(z),    (D)
// s_d again refinable with int s_d = 1, on a support shorter by d.

/// sum += a b, which enclosures do without temporaries.
template <class Scalar>
void add_product(Scalar& sum, const Scalar& a, const Scalar& b) {
  sum += a * b;
}

/// The mask of s_d by (D).
template <class Scalar>
Filter<Scalar> without_zeros_at_pi(Filter<Scalar> mask, int d) {
  for (; d > 0; --d) {
    mask.taps.pop_back();
    for (std::size_t k = 1; k < mask.taps.size(); ++k) mask.taps[k] -= mask.taps[k - 1];
    for (Scalar& tap : mask.taps) tap *= Scalar(2);
  }
  return mask;
}

/// A_m as a list: every s with a value that is not zero by structure.
template <class Scalar>
struct ProductMask {
  struct Entry {
    ShiftSpace::Tuple shift;
    Scalar value;
  };
  std::vector<Entry> entries;
};

template <class Scalar>
ProductMask<Scalar> product_mask(const std::vector<Filter<Scalar>>& masks, int m) {
  const std::size_t dimensions = masks.size() - 1;
  const Filter<Scalar>& a = masks.front();
  std::vector<int> lowest, sizes;
  std::size_t count = 1;
  for (std::size_t i = 0; i < dimensions; ++i) {
    lowest.push_back(masks[i + 1].first_index - a.last_index());
    sizes.push_back(masks[i + 1].last_index() - a.first_index - lowest[i] + 1);
    count *= static_cast<std::size_t>(sizes[i]);
  }
  std::vector<Scalar> sums(count, Scalar(0));
  std::vector<char> is_set(count, 0);
  const auto add = [&](const auto& self, int n, const Scalar& product, std::size_t dimension,
                       std::size_t place) -> void {
    if (dimension == dimensions) {
      sums[place] += product;
      is_set[place] = 1;
      return;
    }
    const Filter<Scalar>& b = masks[dimension + 1];
    for (int k = b.first_index; k <= b.last_index(); ++k) {
      const auto step = static_cast<std::size_t>(k - n - lowest[dimension]);
      self(self, n, Scalar(product * b[k]), dimension + 1,
           place * static_cast<std::size_t>(sizes[dimension]) + step);
    }
  };
  for (int n = a.first_index; n <= a.last_index(); ++n) {
    Scalar weighted = a[n] / Scalar(2);
    for (int i = 0; i < m; ++i) weighted *= Scalar(n);
    add(add, n, weighted, 0, 0);
  }
  ProductMask<Scalar> result;
  for (std::size_t place = 0; place < count; ++place) {
    if (!is_set[place]) continue;
    ShiftSpace::Tuple shift{};
    for (std::size_t i = dimensions, rest = place; i-- > 0;) {
      const auto size = static_cast<std::size_t>(sizes[i]);
      shift[i] = lowest[i] + static_cast<int>(rest % size);
      rest /= size;
    }
    result.entries.push_back({shift, std::move(sums[place])});
  }
  return result;
}

/// Calls visit(unknown, s) for every s of the mask with 2y + s in the space, y of the unknown
/// `row`.
template <class Scalar, class Visit>
void visit_row(const ShiftSpace& space, const ProductMask<Scalar>& mask, int row, Visit visit) {
  ShiftSpace::Tuple doubled = space.representative(row);
  for (int& shift : doubled) shift *= 2;
  for (const auto& entry : mask.entries) {
    ShiftSpace::Tuple y{};
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = doubled[i] + entry.shift[i];
    const int unknown = space.unknown(y);
    if (unknown >= 0) visit(unknown, entry.value);
  }
}

/// A power of two >= the number of tuples: with u = 1 over it, u 1^T is about as large as A_0, and
/// exact.
inline double tuples_rounded_up(const ShiftSpace& space) {
  double tuples = 0, power = 1;
  for (int i = 0; i < space.size(); ++i) tuples += space.multiplicity(i);
  while (power < tuples) power *= 2;
  return power;
}

/// A_m D.
template <class Scalar>
std::vector<Scalar> apply(const ShiftSpace& space, const ProductMask<Scalar>& mask,
                          const std::vector<Scalar>& d) {
  std::vector<Scalar> result(d.size(), Scalar(0));
  for (int row = 0; row < space.size(); ++row) {
    Scalar& sum = result[static_cast<std::size_t>(row)];
    visit_row(space, mask, row, [&](int unknown, const Scalar& value) {
      add_product(sum, value, d[static_cast<std::size_t>(unknown)]);
    });
  }
  return result;
}

}  // namespace wavecurve
