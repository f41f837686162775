#include "wavecurve/certified/detail/elementary/rounded_ball.hpp"

#include <utility>

namespace wavecurve::certified {

namespace {

double bound_of(void (*get)(arf_t, const arb_t), arf_rnd_t direction, const Ball& x) {
  arf_t bound;
  arf_init(bound);
  get(bound, x.get());
  const double result = arf_get_d(bound, direction);
  arf_clear(bound);
  return result;
}

}  // namespace

double largest_magnitude(const Ball& x) {
  return bound_of([](arf_t bound, const arb_t y) { arb_get_abs_ubound_arf(bound, y, 53); },
                  ARF_RND_UP, x);
}

double smallest_magnitude(const Ball& x) {
  return bound_of([](arf_t bound, const arb_t y) { arb_get_abs_lbound_arf(bound, y, 53); },
                  ARF_RND_DOWN, x);
}

RoundedBall RoundedBall::rounded(Ball value, double error) {
  error *= slack;
  error += unit_of((largest_magnitude(value) + error) * slack) / 2;
  return {std::move(value), error * slack};
}

RoundedBall operator*(const RoundedBall& a, const RoundedBall& b) {
  return RoundedBall::rounded(a.value_ * b.value_, largest_magnitude(a.value_) * b.error_ +
                                                       largest_magnitude(b.value_) * a.error_ +
                                                       a.error_ * b.error_);
}

RoundedBall operator/(const RoundedBall& a, const RoundedBall& b) {
  // (a + x) / (b + y) - a / b = (x - y a / b) / (b + y).
  const Ball quotient = a.value_ / b.value_;
  const double divisor = smallest_magnitude(b.value_) - b.error_;
  return RoundedBall::rounded(quotient,
                              (a.error_ + largest_magnitude(quotient) * b.error_) / divisor);
}

elementary::Sum<RoundedBall> compensated_sum(const RoundedBall& a, const RoundedBall& b,
                                             const RoundedBall& small) {
  if (a.value() == Ball() && a.error() == 0) return {b, small};  // 0 + b loses nothing
  const Ball sum = a.value() + b.value();
  const double error = a.error() + b.error();
  const double lost = unit_of(largest_magnitude(sum) + error) / 2;
  const double last = unit_of(lost + largest_magnitude(small.value()) + small.error()) / 2;
  return {{sum, error}, {small.value(), small.error() + last}};
}

}  // namespace wavecurve::certified
