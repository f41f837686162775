#include "wavecurve/certified/detail/elementary/elementary_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "wavecurve/certified/detail/elementary/polynomial_fit.hpp"
#include "wavecurve/certified/detail/elementary/rounded_ball.hpp"
#include "wavecurve/elementary/detail/reduced.hpp"

namespace wavecurve::certified {

namespace {

using elementary::Sum;

Ball power_of_two(int exponent) { return Ball::from_double(std::ldexp(1.0, exponent)); }

/// All numbers from -x to x.
Ball up_to(double x) { return hull(Ball::from_double(-x), Ball::from_double(x)); }

Ball arctan(const Ball& x) {
  Ball result;
  arb_atan(result.get(), x.get(), WorkingPrecision::bits());
  return result;
}

Ball inverse_factorial(int n) {
  Ball product = 1;
  for (int i = 2; i <= n; ++i) product *= i;
  return Ball(1) / product;
}

Ball alternating(int i, Ball x) { return i % 2 == 0 ? x : -x; }

template <std::size_t N>
double fit(std::array<double, N>& coefficients, const SeriesOnInterval& series) {
  const std::vector<double> fitted = fit_polynomial(series, static_cast<int>(N));
  std::copy(fitted.begin(), fitted.end(), coefficients.begin());
  return distance_on_interval(series, fitted);
}

/// Pieces that cover from .. to, so many of equal length.
std::vector<Ball> equal_pieces(const Ball& from, const Ball& to, int count) {
  std::vector<Ball> pieces;
  const Ball step = (to - from) / count;
  for (int i = 0; i < count; ++i) pieces.push_back(hull(from + step * i, from + step * (i + 1)));
  return pieces;
}

/// Pieces that cover 2^-70 .. to, each so small a part of its numbers. Numbers below 2^-70 need no
/// piece: there the tails are below 2^-54 of a unit.
std::vector<Ball> pieces_towards_zero(const Ball& to) {
  constexpr int parts = 32;
  std::vector<Ball> pieces;
  for (int e = -70; smallest_magnitude(to) > std::ldexp(1.0, e); ++e) {
    for (const Ball& piece : equal_pieces(power_of_two(e), power_of_two(e + 1), parts)) {
      if (!certainly_less(to, piece)) pieces.push_back(piece);
    }
  }
  return pieces;
}

/// The largest error so far, in units.
class Worst {
 public:
  explicit Worst(double& units) : units_(units) {}
  void add(const Sum<RoundedBall>& sum, const Ball& truth, double approximation) {
    const double error = sum.head.error() + sum.tail.error() + approximation;
    units_ = std::max(units_, (0.5 + error / unit_of(smallest_magnitude(truth))) * (1 + 1e-12));
  }

 private:
  double& units_;
};

void bound_sine_and_cosine(const ElementaryPolynomials& p, ElementaryBounds& bounds) {
  Worst sine(bounds.sine), cosine(bounds.cosine);
  for (const Ball& r : pieces_towards_zero(largest_angle())) {
    const double size = largest_magnitude(r), low = unit_of(size) / 2;
    const RoundedBall angle(r, 0), rest(up_to(low), 0);
    // The low part is multiplied by 1 - r^2/2 and by r in the place of cos(r), sin(r) and of what
    // is of second order.
    const double reduced = size * reduction_error() + low * low;
    sine.add(elementary::reduced_sine(p.sine, angle, rest), sin(r),
             p.sine_distance * std::pow(size, 3) + low * std::pow(size, 4) / 24 + reduced);
    cosine.add(elementary::reduced_cosine(p.cosine, angle, rest), cos(r),
               p.cosine_distance * std::pow(size, 4) + low * std::pow(size, 3) / 6 + reduced);
  }
}

/// k log(2) is subtracted in two parts: the second product and what is left of log(2) err by 2^-85
/// together, and the low part too where it is the larger one.
constexpr double log_2_error = 0x1p-84;

void bound_exponential(const ElementaryPolynomials& p, ElementaryBounds& bounds) {
  Worst plain(bounds.exponential), minus_one(bounds.exponential_minus_one);
  const Ball end = largest_reduced_exponent();
  for (const Ball& r : equal_pieces(-end, end, 512)) {
    const double size = largest_magnitude(r), low = unit_of(size) / 2;
    const RoundedBall exponent(r, 0), rest(up_to(low), 0);
    const auto sum = elementary::reduced_exponential(p.exponential, exponent, rest);
    // The low part is added without its factor e^r.
    const Ball truth = exp(r);
    const double factor = largest_magnitude(truth - 1);
    const double approximation =
        p.exponential_distance * size * size + low * factor + low * low + log_2_error;
    plain.add(sum, truth, approximation);
    for (int k = -58; k <= 145; ++k) {
      if (k == 0) continue;
      const double scale = std::ldexp(1.0, k);
      const RoundedBall head(sum.head.value() * power_of_two(k), sum.head.error() * scale);
      const RoundedBall tail(sum.tail.value() * power_of_two(k), sum.tail.error() * scale);
      minus_one.add(compensated_sum(head, -1.0, tail), truth * power_of_two(k) - 1,
                    approximation * scale);
    }
  }
  for (const Ball& positive : pieces_towards_zero(end)) {
    for (const Ball& r : {positive, -positive}) {
      minus_one.add(elementary::reduced_exponential_minus_one(p.exponential, RoundedBall(r, 0)),
                    exp(r) - 1, p.exponential_distance * std::pow(largest_magnitude(r), 2));
    }
  }
}

void bound_logarithm(const ElementaryPolynomials& p, ElementaryBounds& bounds) {
  Worst worst(bounds.logarithm);
  const TwoParts parts = parts_of_log_2();
  const Ball log_2 = log(Ball(2)), rest = log_2 - Ball::from_double(parts.head);
  const auto add = [&](const Ball& f, int k) {
    const RoundedBall low(rest * k, k == 0 ? 0 : log_2_error);
    const Ball s = f / (f + 2);
    worst.add(elementary::reduced_logarithm(p.logarithm, RoundedBall(f, 0),
                                            RoundedBall(k * parts.head), low),
              log(f + 1) + log_2 * k, p.logarithm_distance * std::pow(largest_magnitude(s), 3));
  };
  const Ball least = Ball(-5) / 16, most = Ball(3) / 8;  // 11/16 <= 1 + f < 11/8
  for (const Ball& f : pieces_towards_zero(most)) add(f, 0);
  for (const Ball& f : pieces_towards_zero(-least)) add(-f, 0);
  for (const Ball& f : equal_pieces(least, most, 32)) {
    for (int k = -1074; k <= 1024; ++k) {
      if (k != 0) add(f, k);
    }
  }
}

void bound_arctangent(const ElementaryPolynomials& p, ElementaryBounds& bounds) {
  Worst worst(bounds.arctangent);
  const TwoParts half_pi = two_doubles(Ball::pi() / 2);
  const auto add = [&](const Sum<RoundedBall>& angle, const Ball& truth, double approximation) {
    worst.add(angle, truth, approximation);
    for (const auto& [turns, sign] : {std::pair(1, -1), {1, 1}, {2, -1}}) {
      const RoundedBall factor(static_cast<double>(sign));
      const RoundedBall base(turns * half_pi.head);
      // The sign and the small whole factor are exact.
      const RoundedBall head(angle.head.value() * sign, angle.head.error());
      const RoundedBall tail(angle.tail.value() * sign, angle.tail.error());
      worst.add(compensated_sum(base, head, RoundedBall(turns * half_pi.tail) + tail),
                Ball::pi() * turns / 2 + truth * sign, approximation + 0x1p-105);
    }
  };
  // The low part is below half a unit, its factor is that of first order, and it errs by two
  // roundings.
  const auto low_part = [](double size) {
    return RoundedBall(up_to(unit_of(size) / 2), unit_of(size) * 0x1p-52);
  };
  for (const Ball& q : pieces_towards_zero(Ball(27) / 64)) {
    const double size = largest_magnitude(q);
    const RoundedBall quotient(q, 0), low = low_part(size);
    add({quotient, elementary::small_arctangent_tail(p.arctangent, quotient, low)}, arctan(q),
        p.arctangent_distance * std::pow(size, 3) + std::pow(unit_of(size), 2));
  }
  for (int j = first_arctangent; j <= 32; ++j) {
    const auto [head, rest] = parts_of_arctangent(j);
    for (const Ball& q : equal_pieces(Ball(2 * j - 1) / 64, Ball(2 * j + 1) / 64, 32)) {
      const double size = largest_magnitude(q);
      add({RoundedBall(head), elementary::arctangent_tail(p.arctangent, j / 32.0, rest,
                                                          RoundedBall(q, 0), low_part(size))},
          arctan(q), p.arctangent_distance * 0x1p-18 + std::pow(unit_of(size), 2) + 0x1p-106);
    }
  }
}

}  // namespace

Ball largest_angle() { return Ball::pi() / 4 + power_of_two(-31); }
Ball largest_reduced_exponent() { return log(Ball(2)) / 2 + power_of_two(-40); }

TwoParts two_doubles(const Ball& x) {
  const double head = x.to_double();
  return {head, (x - Ball::from_double(head)).to_double()};
}

TwoParts parts_of_log_2() {
  const Ball log_2 = log(Ball(2));
  const double head = std::ldexp(std::floor(std::ldexp(log_2.to_double(), 42)), -42);
  return {head, (log_2 - Ball::from_double(head)).to_double()};
}

TwoParts parts_of_arctangent(int j) { return two_doubles(arctan(Ball(j) / 32)); }

ElementaryPolynomials elementary_polynomials() {
  ElementaryPolynomials p;
  const Ball zero, angle = pow(largest_angle(), 2), exponent = largest_reduced_exponent();
  p.sine_distance = fit(p.sine, series_on(zero, angle, 30, 0.01, [](int i) {
                          return alternating(i + 1, inverse_factorial(2 * i + 3));
                        }));
  p.cosine_distance = fit(p.cosine, series_on(zero, angle, 30, 0.01, [](int i) {
                            return alternating(i, inverse_factorial(2 * i + 4));
                          }));
  p.exponential_distance =
      fit(p.exponential,
          series_on(-exponent, exponent, 30, 0.02, [](int i) { return inverse_factorial(i + 2); }));
  const Ball s = Ball(5) / 27;  // |f / (2 + f)| is largest for f = -5/16
  p.logarithm_distance = fit(
      p.logarithm, series_on(zero, s * s, 60, 0.05, [](int i) { return Ball(2) / (2 * i + 3); }));
  p.arctangent_distance =
      fit(p.arctangent, series_on(zero, pow(Ball(27) / 64, 2), 100, 0.18,
                                  [](int i) { return alternating(i + 1, Ball(1) / (2 * i + 3)); }));
  return p;
}

double least_distance_to_quarter_turn() {
  const WorkingPrecision precision(2600);
  double least = 1;
  for (int e = -53; e <= 971; ++e) {
    // The continued fraction of 2^e / (pi/2), as far as denominators go up to 2^53. Then |m a - k|
    // >= |q a - p| for all m < 2^53, of the last convergent p / q (Lagrange).
    Ball scale = 1;
    arb_mul_2exp_si(scale.get(), scale.get(), e);
    const Ball a = scale * 2 / Ball::pi();
    Ball x = a, p = 1, last_p = 0, q = 0, last_q = 1;
    while (true) {
      Ball whole;
      arb_floor(whole.get(), x.get(), WorkingPrecision::bits());
      if (!whole.is_exact()) throw std::logic_error("the precision is too low for 2/pi");
      Ball next_p = whole * p + last_p, next_q = whole * q + last_q;
      if (!certainly_less(next_q, power_of_two(53))) break;
      last_p = std::exchange(p, next_p);
      last_q = std::exchange(q, next_q);
      x = Ball(1) / (x - whole);
    }
    // A quotient of 0 means angles below pi/4, which are not reduced.
    if (p.contains_zero()) continue;
    least = std::min(least, smallest_magnitude((q * a - p) * Ball::pi() / 2));
  }
  return least;
}

// In doubles (elementary/detail/quarter_turns.cpp): with k < 2^20, the fourth part of pi/2 errs by
// 2^-150, its product with k of 2^-75 rounds by 2^-129; the two differences' errors, which are
// exact, sum up to 2^-52 |r| + 2^-74, for a third part below 2^-63 is not in the first difference
// yet, and are rounded three times: 2^-126 and 2^-103 |r|, together below 2^-125 + 2^-103 |r|.
// In whole numbers, the bits that are left out add up to 2^-137, and three roundings of doubled
// doubles to 2^-103 |r|.
double reduction_error() {
  static const double error =
      (0x1p-125 / least_distance_to_quarter_turn() + 0x1p-103) * (1 + 1e-12);
  return error;
}

ElementaryBounds elementary_bounds(const ElementaryPolynomials& polynomials) {
  ElementaryBounds bounds;
  bound_sine_and_cosine(polynomials, bounds);
  bound_exponential(polynomials, bounds);
  bound_logarithm(polynomials, bounds);
  bound_arctangent(polynomials, bounds);
  return bounds;
}

}  // namespace wavecurve::certified
