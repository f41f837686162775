#pragma once

#include <optional>

#include "wavecurve/certified/flint.hpp"
#include "wavecurve/certified/rational.hpp"

namespace wavecurve::certified {

/// Sets the precision in bits of all Ball arithmetic of this thread, until the end of its scope.
class WorkingPrecision {
 public:
  explicit WorkingPrecision(long bits);
  ~WorkingPrecision();
  WorkingPrecision(const WorkingPrecision&) = delete;
  WorkingPrecision& operator=(const WorkingPrecision&) = delete;
  static long bits();

 private:
  long previous_;
};

/// An enclosure: a midpoint and a radius, within which the true value lies (Arb's arb as a value
/// type). Every operation encloses the exact result for all numbers in its operands.
class Ball {
 public:
  Ball() { arb_init(value_); }
  Ball(long integer) : Ball() { arb_set_si(value_, integer); }
  Ball(const Rational& exact);
  Ball(const Ball& other) : Ball() { arb_set(value_, other.value_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(value_, other.value_); }
  Ball& operator=(Ball other) noexcept {
    arb_swap(value_, other.value_);
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  static Ball from_double(double exact);
  /// All numbers within radius of the midpoint.
  static Ball around(const Rational& midpoint, const Rational& radius);
  static Ball pi();

  Ball& operator+=(const Ball& b);
  Ball& operator-=(const Ball& b);
  Ball& operator*=(const Ball& b);
  Ball& operator/=(const Ball& b);
  friend Ball operator+(Ball a, const Ball& b) { return a += b; }
  friend Ball operator-(Ball a, const Ball& b) { return a -= b; }
  friend Ball operator*(Ball a, const Ball& b) { return a *= b; }
  friend Ball operator/(Ball a, const Ball& b) { return a /= b; }
  friend Ball operator-(Ball a) { return arb_neg(a.value_, a.value_), a; }

  /// The same enclosure, not the same number.
  friend bool operator==(const Ball& a, const Ball& b) {
    return arb_equal(a.value_, b.value_) != 0;
  }
  /// True if proved; false may also mean undecided.
  friend bool certainly_less(const Ball& a, const Ball& b) {
    return arb_lt(a.value_, b.value_) != 0;
  }

  bool is_exact() const { return arb_is_exact(value_) != 0; }
  bool is_finite() const { return arb_is_finite(value_) != 0; }
  bool contains_zero() const { return arb_contains_zero(value_) != 0; }
  bool contains(const Rational& number) const {
    return arb_contains_fmpq(value_, number.get()) != 0;
  }
  bool contains(const Ball& other) const { return arb_contains(value_, other.value_) != 0; }
  bool overlaps(const Ball& other) const { return arb_overlaps(value_, other.value_) != 0; }
  bool is_positive() const { return arb_is_positive(value_) != 0; }

  /// The midpoint alone, as an exact ball.
  Ball midpoint() const;
  /// The radius, as an exact ball.
  Ball radius() const;
  /// The number, if the radius is zero.
  std::optional<Rational> exact_value() const;
  /// The midpoint rounded to nearest; not certified, see nearest_double.
  double to_double() const;
  /// An upper bound of the radius.
  double radius_double() const;
  /// Bits of relative accuracy: large for a tight enclosure, negative for one of no use.
  long accuracy_bits() const { return arb_rel_accuracy_bits(value_); }

  const arb_struct* get() const { return value_; }
  arb_struct* get() { return value_; }

 private:
  arb_t value_;
};

Ball sqrt(const Ball& x);
Ball abs(const Ball& x);
Ball cos(const Ball& x);
Ball sin(const Ball& x);
Ball log(const Ball& x);
Ball exp(const Ball& x);
Ball pow(const Ball& x, unsigned long n);
/// The smallest ball that holds both.
Ball hull(const Ball& a, const Ball& b);

}  // namespace wavecurve::certified
