#pragma once

#include <compare>
#include <string>
#include <string_view>

#include "wavecurve/certified/flint.hpp"

namespace wavecurve::certified {

/// An exact rational number (FLINT's fmpq as a value type).
class Rational {
 public:
  Rational() { fmpq_init(value_); }
  Rational(long integer) : Rational() { fmpq_set_si(value_, integer, 1); }
  Rational(long numerator, long denominator);
  Rational(const Rational& other) : Rational() { fmpq_set(value_, other.value_); }
  Rational(Rational&& other) noexcept : Rational() { fmpq_swap(value_, other.value_); }
  Rational& operator=(Rational other) noexcept {
    fmpq_swap(value_, other.value_);
    return *this;
  }
  ~Rational() { fmpq_clear(value_); }

  /// The exact value of a decimal in fixed or scientific notation, such as "-0.25" or "1e-3".
  /// Throws std::invalid_argument, naming the text, if it is not one or its exponent exceeds 10000.
  static Rational from_decimal(std::string_view decimal);
  static Rational power_of_two(long exponent);
  static Rational binomial(unsigned long n, unsigned long k);
  static Rational factorial(unsigned long n);

  Rational& operator+=(const Rational& b) { return fmpq_add(value_, value_, b.value_), *this; }
  Rational& operator-=(const Rational& b) { return fmpq_sub(value_, value_, b.value_), *this; }
  Rational& operator*=(const Rational& b) { return fmpq_mul(value_, value_, b.value_), *this; }
  /// Throws std::domain_error for a zero divisor.
  Rational& operator/=(const Rational& b);

  friend Rational operator+(Rational a, const Rational& b) { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }
  friend Rational operator-(Rational a) { return fmpq_neg(a.value_, a.value_), a; }
  friend bool operator==(const Rational& a, const Rational& b) {
    return fmpq_equal(a.value_, b.value_) != 0;
  }
  friend auto operator<=>(const Rational& a, const Rational& b) {
    return fmpq_cmp(a.value_, b.value_) <=> 0;
  }

  bool is_zero() const { return fmpq_is_zero(value_) != 0; }
  /// is_zero() under the name that Ball has for it, for templates over both.
  bool contains_zero() const { return is_zero(); }
  int sign() const { return fmpq_sgn(value_); }
  Rational abs() const { return sign() < 0 ? -*this : *this; }
  /// "p/q" in lowest terms, or "p" for an integer.
  std::string to_string() const;

  const fmpq* get() const { return value_; }
  fmpq* get() { return value_; }

 private:
  fmpq_t value_;
};

}  // namespace wavecurve::certified
