#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "wavecurve/integrals/product_integral.hpp"

namespace wavecurve {

/// The integers between which a refinable function does not vanish, and a number that functions
/// share that are the same.
struct ShiftedFunction {
  int first = 0, last = 0;
  int kind = 0;
};

/// The unknowns of a two-scale system of products: the tuples y = (y_2, .., y_k) for which the
/// supports of
///   s_1(x), s_2(x - y_2), .., s_k(x - y_k)
/// meet in more than a point. Tuples that an exchange of equal functions maps onto each other have
/// the same integral, and are one unknown: G(y_2, y_3) = G(y_3, y_2) if s_2 = s_3, and
/// G(y_2) = G(-y_2) if s_1 = s_2.
class ShiftSpace {
 public:
  static constexpr std::size_t most_dimensions = most_factors - 1;
  using Tuple = std::array<int, most_dimensions>;

  /// Throws std::invalid_argument if there would be more than most_unknowns.
  explicit ShiftSpace(const std::vector<ShiftedFunction>& functions);

  std::size_t dimensions() const { return lowest_.size(); }
  int size() const { return static_cast<int>(representatives_.size()); }
  /// One tuple of each unknown.
  const Tuple& representative(int unknown) const {
    return representatives_[static_cast<std::size_t>(unknown)];
  }
  /// How many tuples are this unknown.
  int multiplicity(int unknown) const { return multiplicities_[static_cast<std::size_t>(unknown)]; }
  int largest_multiplicity() const;

  /// The unknown of a tuple, or -1 where the integral vanishes.
  int unknown(const Tuple& y) const {
    std::size_t place = 0;
    for (std::size_t i = 0; i < lowest_.size(); ++i) {
      const int index = y[i] - lowest_[i];
      if (index < 0 || index >= sizes_[i]) return -1;
      place = place * static_cast<std::size_t>(sizes_[i]) + static_cast<std::size_t>(index);
    }
    return unknowns_[place];
  }

  /// The box of all tuples: lowest index and extent of each dimension.
  const std::vector<int>& lowest() const { return lowest_; }
  const std::vector<int>& sizes() const { return sizes_; }
  /// The unknown of every tuple of the box, the last index running fastest.
  const std::vector<int>& unknowns() const { return unknowns_; }

 private:
  bool supports_meet(const std::vector<ShiftedFunction>& functions, const Tuple& y) const;
  void number_tuple(const std::vector<ShiftedFunction>& functions, const Tuple& y);
  Tuple canonical(const std::vector<ShiftedFunction>& functions, const Tuple& y) const;
  int& entry(const Tuple& y);

  std::vector<int> lowest_, sizes_, unknowns_;
  std::vector<Tuple> representatives_;
  std::vector<int> multiplicities_;
};

}  // namespace wavecurve
