#include "wavecurve/curves/detail/orient2d.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace wavecurve {

namespace {

int sign(double value) { return (value > 0) - (value < 0); }

/// A sum of doubles without rounding: its parts, of increasing magnitude, do not overlap.
class Expansion {
 public:
  /// Adds a b, split into the rounded product and its rounding error.
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  /// The largest part that is not zero exceeds the sum of all the smaller ones.
  int sign_of_sum() const {
    for (std::size_t i = size_; i-- > 0;) {
      if (parts_[i] != 0) return sign(parts_[i]);
    }
    return 0;
  }

 private:
  /// Shewchuk's Grow-Expansion: a chain of exact sums of two (Knuth).
  void add(double value) {
    double carry = value;
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = carry + parts_[i];
      const double virtual_part = sum - carry;
      parts_[i] = (carry - (sum - virtual_part)) + (parts_[i] - virtual_part);
      carry = sum;
    }
    parts_[size_++] = carry;
  }

  std::array<double, 12> parts_{};  ///< six products, two parts each
  std::size_t size_ = 0;
};

/// The determinant with its brackets opened: a x b + b x c + c x a.
int exact_orient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  Expansion sum;
  sum.add_product(a.x(), b.y());
  sum.add_product(-a.y(), b.x());
  sum.add_product(b.x(), c.y());
  sum.add_product(-b.y(), c.x());
  sum.add_product(c.x(), a.y());
  sum.add_product(-c.y(), a.x());
  return sum.sign_of_sum();
}

}  // namespace

int orient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double determinant = left - right;
  // Each product carries three roundings, the difference one: (3 + 16 u) u of the sum of their
  // magnitudes bounds the error, u = 2^-53 (Shewchuk, section 4.3).
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  const double magnitude = std::abs(left) + std::abs(right);
  const double bound = (3 + 16 * u) * u * magnitude;
  if (determinant > bound || -determinant > bound) return sign(determinant);
  // Each product has a factor zero: two points are the same, as at the ends of neighbouring edges,
  // or all lie on a line along an axis. None is lost to underflow: a difference is a unit in the
  // last place or more, and two of them keep a product of 2^-960 above 2^-1066.
  if (magnitude == 0) return 0;
  return exact_orient2d(a, b, c);
}

}  // namespace wavecurve
