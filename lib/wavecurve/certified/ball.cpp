#include "wavecurve/certified/ball.hpp"

#include <stdexcept>
#include <string>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

thread_local long working_bits = 128;

}  // namespace

WorkingPrecision::WorkingPrecision(long bits) : previous_(working_bits) {
  check_at_least("the working precision in bits", bits, 2);
  working_bits = bits;
}

WorkingPrecision::~WorkingPrecision() { working_bits = previous_; }

long WorkingPrecision::bits() { return working_bits; }

Ball::Ball(const Rational& exact) : Ball() { arb_set_fmpq(value_, exact.get(), working_bits); }

Ball Ball::from_double(double exact) {
  Ball result;
  arb_set_d(result.value_, exact);
  return result;
}

Ball Ball::around(const Rational& midpoint, const Rational& radius) {
  Ball result(midpoint);
  const Ball r(radius);
  arb_add_error(result.value_, r.value_);
  return result;
}

Ball Ball::pi() {
  Ball result;
  arb_const_pi(result.value_, working_bits);
  return result;
}

Ball& Ball::operator+=(const Ball& b) {
  arb_add(value_, value_, b.value_, working_bits);
  return *this;
}

Ball& Ball::operator-=(const Ball& b) {
  arb_sub(value_, value_, b.value_, working_bits);
  return *this;
}

Ball& Ball::operator*=(const Ball& b) {
  arb_mul(value_, value_, b.value_, working_bits);
  return *this;
}

Ball& Ball::operator/=(const Ball& b) {
  arb_div(value_, value_, b.value_, working_bits);
  return *this;
}

Ball Ball::midpoint() const {
  Ball result;
  arb_get_mid_arb(result.value_, value_);
  return result;
}

Ball Ball::radius() const {
  Ball result;
  arb_get_rad_arb(result.value_, value_);
  return result;
}

std::optional<Rational> Ball::exact_value() const {
  if (!is_exact() || !is_finite()) return std::nullopt;
  Rational result;
  arf_get_fmpq(result.get(), arb_midref(value_));
  return result;
}

double Ball::to_double() const { return arf_get_d(arb_midref(value_), ARF_RND_NEAR); }

double Ball::radius_double() const {
  const Ball r = radius();
  return arf_get_d(arb_midref(r.value_), ARF_RND_UP);
}

Ball sqrt(const Ball& x) {
  Ball result;
  arb_sqrt(result.get(), x.get(), WorkingPrecision::bits());
  return result;
}

Ball abs(const Ball& x) {
  Ball result;
  arb_abs(result.get(), x.get());
  return result;
}

Ball cos(const Ball& x) {
  Ball result;
  arb_cos(result.get(), x.get(), WorkingPrecision::bits());
  return result;
}

Ball sin(const Ball& x) {
  Ball result;
  arb_sin(result.get(), x.get(), WorkingPrecision::bits());
  return result;
}

Ball log(const Ball& x) {
  Ball result;
  arb_log(result.get(), x.get(), WorkingPrecision::bits());
  return result;
}

Ball exp(const Ball& x) {
  Ball result;
  arb_exp(result.get(), x.get(), WorkingPrecision::bits());
  return result;
}

Ball pow(const Ball& x, unsigned long n) {
  Ball result;
  arb_pow_ui(result.get(), x.get(), n, WorkingPrecision::bits());
  return result;
}

Ball hull(const Ball& a, const Ball& b) {
  Ball result;
  arb_union(result.get(), a.get(), b.get(), WorkingPrecision::bits());
  return result;
}

}  // namespace wavecurve::certified
