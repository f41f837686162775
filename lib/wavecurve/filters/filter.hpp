#pragma once

#include <cstddef>
#include <vector>

namespace wavecurve {

/// A finite sequence h_n, n = first_index .. last_index(), zero outside.
///
/// Scalar is double or float for computing, certified::Ball or certified::Rational for proofs.
/// Low-pass filters have the orthonormal normalisation, sum h_n = sqrt 2.
template <class Scalar = double>
struct Filter {
  int first_index = 0;
  std::vector<Scalar> taps;

  int size() const { return static_cast<int>(taps.size()); }
  int last_index() const { return first_index + size() - 1; }

  /// h_n for every integer n.
  Scalar operator[](int n) const {
    const bool inside = n >= first_index && n <= last_index();
    return inside ? taps[static_cast<std::size_t>(n - first_index)] : Scalar(0);
  }

  bool operator==(const Filter&) const = default;
};

}  // namespace wavecurve
