#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/integrals/shift_tensor.hpp"

namespace wavecurve {

/// The integrals of the same factors made periodic, f_N(x) = sum_j f(x - N j), over one period: for
/// l, m, .. from 0 to n - 1 the sum of all I(l + n i, m + n j, ..). It holds for any n >= 1, also
/// where the supports exceed the period (Restrepo and Leaf 1997). Two factors give the first column
/// of a circulant matrix.
template <class Scalar>
ShiftTensor<Scalar> periodized(const ShiftTensor<Scalar>& integrals, int n) {
  const std::size_t dimensions = integrals.dimensions();
  ShiftTensor<Scalar> result(std::vector<int>(dimensions, 0), std::vector<int>(dimensions, n));
  for (std::size_t place = 0; place < integrals.values.size(); ++place) {
    std::size_t target = 0;
    for (const int index : integrals.indices(place)) {
      target = target * static_cast<std::size_t>(n) + static_cast<std::size_t>((index % n + n) % n);
    }
    result.values[target] += integrals.values[place];
  }
  return result;
}

/// The bilinear form of three factors on periodic coefficients,
///   w_i = sum_{l,m} I(l, m) u_{i+l} v_{i+m},   indices modulo the length n of u and v,
/// that is int f(x - i) U(x) V(x) dx of U = sum_j u_j g(x - j) and V = sum_j v_j h(x - j). Time
/// grows with n times the integrals that do not vanish. `integrals` are those of the line, not
/// periodized. Throws std::invalid_argument unless there are two dimensions, and as many entries of
/// u as of v.
Eigen::VectorXd periodic_bilinear_form(const ShiftTensor<double>& integrals,
                                       const Eigen::Ref<const Eigen::VectorXd>& u,
                                       const Eigen::Ref<const Eigen::VectorXd>& v);

}  // namespace wavecurve
