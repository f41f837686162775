#include "wavecurve/certified/detail/derivative_over_taps.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wavecurve/certified/detail/polynomial.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/refinable.hpp"
#include "wavecurve/filters/autocorrelation.hpp"

namespace wavecurve::certified {
namespace {

Rational random_share() { return Rational(*rc::gen::inRange(-1000L, 1001L), 1000); }

/// A box that holds the taps anywhere, or in a corner, where the second order counts most.
Filter<Ball> box_around(const Filter<Ball>& taps, const Rational& radius) {
  Filter<Ball> box{taps.first_index, {}};
  const bool in_a_corner = *rc::gen::arbitrary<bool>();
  for (const Ball& tap : taps.taps) {
    const Rational share =
        in_a_corner ? Rational(*rc::gen::elementOf(std::vector<long>{-1, 1})) : random_share();
    box.taps.push_back(tap.midpoint() + Ball(radius * share));
    arb_add_error(box.taps.back().get(), Ball(radius).get());
  }
  return box;
}

/// ((1 + x) / 2)^zeros q(x), q(1) = 1: it has no other property, and the two-scale system needs
/// none.
Polynomial<Rational> random_filter(int zeros) {
  Polynomial<Rational> q{Rational(1)};
  for (int k = *rc::gen::inRange(0, 6); k > 0; --k) {
    const Rational c = random_share() / Rational(10);
    q.push_back(Rational(0));
    q[q.size() - 1] += c;
    q[q.size() - 2] -= c;
  }
  return averaging_polynomial<Rational>(zeros) * q;
}

RC_GTEST_PROP(DerivativeOverTaps, EnclosesThatOfEveryFilterInTheBox, ()) {
  const WorkingPrecision precision(300);
  const int d = *rc::gen::inRange(0, 5), zeros = d + 2;
  const auto mask = random_filter(zeros);
  Filter<Rational> alpha = autocorrelation(Filter<Rational>{0, mask});
  for (Rational& value : alpha.taps) value *= Rational(2);
  const auto truth = autocorrelation_derivative_at_integers(alpha, d);

  Filter<Ball> taps{0, {}};
  for (const Rational& m : mask) taps.taps.push_back(Ball(m) * sqrt(Ball(2)));
  const Rational radius = Rational::from_decimal("1e-" + std::to_string(*rc::gen::inRange(9, 40)));
  const auto enclosed = autocorrelation_derivative_over(box_around(taps, radius), d);
  RC_ASSERT(enclosed.first_index == truth.first_index);
  for (std::size_t l = 0; l < truth.taps.size(); ++l) {
    RC_ASSERT(enclosed.taps[l].contains(truth.taps[l]));
  }
}

// A radius r of the taps moves mu_0 by about sum_i |d mu_0 / d h_i| r, and nothing else is of first
// order. The sum is taken here by differences, over a step at which the second order is not seen.
TEST(DerivativeOverTaps, IsNoWiderThanTheTapsAllow) {
  const WorkingPrecision precision(400);
  for (const char* name : {"db4", "sym8", "coif3"}) {
    const Filter<Ball> taps = find_filter(name).bank(400).synthesis_low;
    const Rational radius = Rational::from_decimal("1e-25"), step = Rational::from_decimal("1e-40");
    Filter<Ball> box = taps;
    Ball change(0);
    for (std::size_t i = 0; i < taps.taps.size(); ++i) {
      box.taps[i] = taps.taps[i].midpoint();
      arb_add_error(box.taps[i].get(), Ball(radius).get());
      Filter<Ball> moved[2] = {taps, taps};
      moved[0].taps[i] += Ball(step);
      moved[1].taps[i] -= Ball(step);
      change += abs(autocorrelation_derivative_over(moved[0], 2)[0] -
                    autocorrelation_derivative_over(moved[1], 2)[0]) /
                Ball(Rational(2) * step);
    }
    const Ball width = autocorrelation_derivative_over(box, 2)[0].radius();
    EXPECT_NEAR((width / Ball(radius)).to_double() / change.to_double(), 1, 1e-6) << name;
  }
}

TEST(DerivativeOverTaps, SaysWhenTheTapsAreKnownTooBadly) {
  const WorkingPrecision precision(200);
  Filter<Ball> taps = find_filter("db4").bank(200).synthesis_low;
  for (Ball& tap : taps.taps) arb_add_error(tap.get(), Ball(Rational(1, 10)).get());
  EXPECT_THROW(autocorrelation_derivative_over(taps, 2), std::domain_error);
  EXPECT_THROW(autocorrelation_derivative_over(Filter<Ball>{0, {Ball(1)}}, 2), std::domain_error);
}

}  // namespace
}  // namespace wavecurve::certified
