#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

namespace wavecurve {

/// Numbers for every tuple of integers (l, m, ..) of a box, zero outside.
///
/// Row by row in the first index: the last index runs fastest. A tensor of no dimensions holds one
/// number. Scalar is double, certified::Ball or certified::Rational.
template <class Scalar>
struct ShiftTensor {
  std::vector<int> first;  ///< the lowest index of each dimension
  std::vector<int> sizes;  ///< how many indices each dimension has
  std::vector<Scalar> values;

  ShiftTensor() = default;
  ShiftTensor(std::vector<int> lowest, std::vector<int> extents)
      : first(std::move(lowest)), sizes(std::move(extents)) {
    std::size_t count = 1;
    for (const int size : sizes) count *= static_cast<std::size_t>(size);
    values.assign(count, Scalar(0));
  }

  std::size_t dimensions() const { return sizes.size(); }
  int last(std::size_t dimension) const { return first[dimension] + sizes[dimension] - 1; }

  /// The number at a tuple. Its length must be dimensions().
  Scalar at(std::span<const int> indices) const {
    std::size_t place = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const int index = indices[i] - first[i];
      if (index < 0 || index >= sizes[i]) return Scalar(0);
      place = place * static_cast<std::size_t>(sizes[i]) + static_cast<std::size_t>(index);
    }
    return values[place];
  }
  Scalar at(std::initializer_list<int> indices) const {
    return at(std::span<const int>(indices.begin(), indices.size()));
  }

  /// The tuple of values[place].
  std::vector<int> indices(std::size_t place) const {
    std::vector<int> result(sizes.size());
    for (std::size_t i = sizes.size(); i-- > 0;) {
      result[i] = first[i] + static_cast<int>(place % static_cast<std::size_t>(sizes[i]));
      place /= static_cast<std::size_t>(sizes[i]);
    }
    return result;
  }
};

}  // namespace wavecurve
