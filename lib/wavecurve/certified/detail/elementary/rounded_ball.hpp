#pragma once

#include <cmath>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/elementary/detail/reduced.hpp"

namespace wavecurve::certified {

/// Upper and lower bounds of |x|.
double largest_magnitude(const Ball& x);
double smallest_magnitude(const Ball& x);

/// The unit in the last place of a double of this size, 2^-52 of the power of two below it.
inline double unit_of(double size) {
  return size == 0 ? 0 : std::ldexp(1.0, std::ilogb(size) - 52);
}

/// A number that an algorithm computes in doubles: all that it may be in exact arithmetic, and a
/// bound of how far the rounded result may be from that, each operation rounding to nearest. Run
/// with this number, the text of elementary/detail/reduced.hpp proves its own rounding errors.
class RoundedBall {
 public:
  RoundedBall(double exact) : value_(Ball::from_double(exact)) {}
  RoundedBall(Ball value, double error) : value_(std::move(value)), error_(error) {}

  const Ball& value() const { return value_; }
  double error() const { return error_; }

  friend RoundedBall operator+(const RoundedBall& a, const RoundedBall& b) {
    return rounded(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend RoundedBall operator-(const RoundedBall& a, const RoundedBall& b) {
    return rounded(a.value_ - b.value_, a.error_ + b.error_);
  }
  friend RoundedBall operator*(const RoundedBall& a, const RoundedBall& b);
  friend RoundedBall operator/(const RoundedBall& a, const RoundedBall& b);
  friend RoundedBall operator-(RoundedBall a) { return {-a.value_, a.error_}; }

 private:
  /// The bound is computed in doubles; it is raised by far more than their roundings can lower it.
  static constexpr double slack = 1 + 1e-12;
  static RoundedBall rounded(Ball value, double error);

  Ball value_;
  double error_ = 0;
};

inline RoundedBall half(const RoundedBall& x) {
  return {x.value() * Ball::from_double(0.5), x.error() / 2};
}

/// The sum a + b with what its rounding loses put into the tail: only the tail's last addition
/// rounds, of half a unit of a + b at most and the small number.
elementary::Sum<RoundedBall> compensated_sum(const RoundedBall& a, const RoundedBall& b,
                                             const RoundedBall& small);

}  // namespace wavecurve::certified
