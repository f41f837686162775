#include "wavecurve/elementary/detail/elementary_kernels.hpp"

#include <array>
#include <limits>
#include <stdexcept>

#include "wavecurve/elementary/detail/elementary_tables.hpp"
#include "wavecurve/elementary/detail/highway_targets.hpp"
#include "wavecurve/elementary/detail/quarter_turns.hpp"
#include "wavecurve/elementary/detail/round_to_integer.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "wavecurve/elementary/detail/elementary_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// The operations of reduced.hpp, sine_cosine.cpp and exponential.cpp in their order, on vectors.

HWY_BEFORE_NAMESPACE();
namespace wavecurve::elementary::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<double>;
using V = hn::Vec<Tag>;
using Bits = hn::RebindToUnsigned<Tag>;
using Index = Eigen::Index;
constexpr Index lanes = hn::MaxLanes(Tag());

HWY_INLINE V all(double value) { return hn::Set(Tag(), value); }

template <std::size_t N>
HWY_INLINE V polynomial(const std::array<double, N>& p, V x) {
  V sum = all(p[N - 1]);
  for (std::size_t i = N - 1; i-- > 0;) sum = hn::Add(hn::Mul(x, sum), all(p[i]));
  return sum;
}

/// 1 + b + small for |b| <= 1, rounded.
HWY_INLINE V compensated_sum(V b, V small) {
  const V head = hn::Add(all(1), b);
  return hn::Add(head, hn::Add(hn::Sub(b, hn::Sub(head, all(1))), small));
}

HWY_INLINE V difference(V a, V b, V& rest) {
  const V s = hn::Sub(a, b), part = hn::Sub(s, a);
  rest = hn::Add(rest, hn::Sub(hn::Sub(a, hn::Sub(s, part)), hn::Add(b, part)));
  return s;
}

/// For |x| <= largest_direct_angle; of other lanes the result means nothing.
HWY_INLINE void sine_cosine(V x, V& sine, V& cosine) {
  const V shifted = hn::Add(hn::Mul(x, all(two_over_pi)), all(integer_shift));
  const V k = hn::Sub(shifted, all(integer_shift));
  V low = hn::Zero(Tag());
  V angle = difference(hn::Sub(x, hn::Mul(k, all(half_pi[0]))), hn::Mul(k, all(half_pi[1])), low);
  angle = difference(angle, hn::Mul(k, all(half_pi[2])), low);
  low = hn::Sub(low, hn::Mul(k, all(half_pi[3])));
  V r = hn::Add(angle, low);
  low = hn::Add(hn::Sub(angle, r), low);
  const auto none = hn::Eq(k, hn::Zero(Tag()));
  r = hn::IfThenElse(none, x, r);
  low = hn::IfThenZeroElse(none, low);

  const V square = hn::Mul(r, r), half_square = hn::Mul(all(0.5), square);
  V s = hn::Add(hn::Mul(hn::Mul(square, r), polynomial(sine_polynomial, square)),
                hn::Mul(low, hn::Sub(all(1), half_square)));
  s = hn::IfThenElse(hn::Eq(r, hn::Zero(Tag())), r, hn::Add(r, s));
  const V c = compensated_sum(
      hn::Neg(half_square),
      hn::Sub(hn::Mul(hn::Mul(square, square), polynomial(cosine_polynomial, square)),
              hn::Mul(r, low)));

  // The last bits of the shifted number are the quarter's: odd ones exchange sine and cosine, the
  // upper two change the sine's sign, the middle two the cosine's.
  const Bits bits;
  const auto quarter = hn::BitCast(bits, shifted);
  const auto one = hn::Set(bits, 1), sign = hn::Set(bits, std::uint64_t{1} << 63);
  const V odd = hn::BitCast(Tag(), hn::Sub(hn::Zero(bits), hn::And(quarter, one)));
  const auto sine_sign = hn::And(hn::ShiftLeft<62>(quarter), sign);
  const auto cosine_sign = hn::And(hn::ShiftLeft<62>(hn::Add(quarter, one)), sign);
  sine = hn::Xor(hn::IfVecThenElse(odd, c, s), hn::BitCast(Tag(), sine_sign));
  cosine = hn::Xor(hn::IfVecThenElse(odd, s, c), hn::BitCast(Tag(), cosine_sign));
}

HWY_INLINE V power_of_two(V shifted) {
  const Bits bits;
  const auto one = hn::BitCast(bits, all(1));
  return hn::BitCast(Tag(), hn::Add(hn::ShiftLeft<52>(hn::BitCast(bits, shifted)), one));
}

HWY_INLINE V exponential(V argument) {
  V x = hn::IfThenElse(hn::Lt(argument, all(least_exponent)), all(least_exponent), argument);
  x = hn::IfThenElse(hn::Gt(x, all(largest_exponent)), all(largest_exponent), x);
  const V k =
      hn::Sub(hn::Add(hn::Mul(x, all(one_over_log_2)), all(integer_shift)), all(integer_shift));
  const V above = hn::Sub(x, hn::Mul(k, all(log_2_head))), below = hn::Mul(k, all(log_2_tail));
  const V r = hn::Sub(above, below), low = hn::Sub(hn::Sub(above, r), below);
  const V sum = compensated_sum(
      r, hn::Add(hn::Mul(hn::Mul(r, r), polynomial(exponential_polynomial, r)), low));
  const V shifted = hn::Add(hn::Mul(k, all(0.5)), all(integer_shift));
  const V rest = hn::Sub(k, hn::Sub(shifted, all(integer_shift)));
  const V result =
      hn::Mul(hn::Mul(sum, power_of_two(shifted)), power_of_two(hn::Add(rest, all(integer_shift))));
  return hn::IfThenElse(hn::Eq(argument, argument), result,
                        all(std::numeric_limits<double>::quiet_NaN()));
}

HWY_INLINE void sine_cosine_block(const double* x, double* sine, double* cosine) {
  const V angles = hn::LoadU(Tag(), x);
  V s, c;
  sine_cosine(angles, s, c);
  const bool is_direct = hn::AllTrue(Tag(), hn::Le(hn::Abs(angles), all(largest_direct_angle)));
  hn::StoreU(s, Tag(), sine);
  hn::StoreU(c, Tag(), cosine);
  if (HWY_LIKELY(is_direct)) return;
  HWY_ALIGN double kept[lanes];
  hn::Store(angles, Tag(), kept);
  for (Index i = 0; i < lanes; ++i) {
    const SineCosine one = wavecurve::sine_cosine(kept[i]);
    sine[i] = one.sine;
    cosine[i] = one.cosine;
  }
}

void sine_cosine_loop(const double* x, Index size, double* sine, double* cosine) {
  Index i = 0;
  for (; i + lanes <= size; i += lanes) sine_cosine_block(x + i, sine + i, cosine + i);
  if (i == size) return;
  double angles[lanes] = {}, sines[lanes], cosines[lanes];
  std::copy(x + i, x + size, angles);
  sine_cosine_block(angles, sines, cosines);
  std::copy(sines, sines + (size - i), sine + i);
  std::copy(cosines, cosines + (size - i), cosine + i);
}

void exponential_loop(const double* x, Index size, double* result) {
  Index i = 0;
  for (; i + lanes <= size; i += lanes) {
    hn::StoreU(exponential(hn::LoadU(Tag(), x + i)), Tag(), result + i);
  }
  if (i == size) return;
  double rest[lanes] = {};
  std::copy(x + i, x + size, rest);
  hn::StoreU(exponential(hn::LoadU(Tag(), rest)), Tag(), rest);
  std::copy(rest, rest + (size - i), result + i);
}

}  // namespace wavecurve::elementary::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wavecurve::elementary {

HWY_EXPORT(sine_cosine_loop);
HWY_EXPORT(exponential_loop);

void check_sizes(std::string_view function, Eigen::Index x, Eigen::Index result) {
  if (x == result) return;
  throw std::invalid_argument(must_be("the size of a result of " + std::string(function), result,
                                      "that of x, " + std::to_string(x)));
}

void sine_cosine_of_array(const double* x, Eigen::Index size, double* sine, double* cosine) {
  HWY_DYNAMIC_DISPATCH(sine_cosine_loop)(x, size, sine, cosine);
}

void exponential_of_array(const double* x, Eigen::Index size, double* result) {
  HWY_DYNAMIC_DISPATCH(exponential_loop)(x, size, result);
}

}  // namespace wavecurve::elementary
#endif
