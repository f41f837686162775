#include "wavecurve/certified/ball.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/certified/random_numbers_test.hpp"

namespace wavecurve::certified {
namespace {

constexpr long precisions[] = {2, 30, 53, 128, 300};

long some_precision(RandomNumbers& random) { return precisions[random.integer(0, 4)]; }

Rational middle_of(const Ball& ball) { return exact_value(ball.midpoint()); }
Rational radius_of(const Ball& ball) { return exact_value(ball.radius()); }

/// An end, the middle, or any other number of the ball.
Rational member(RandomNumbers& random, const Ball& ball) {
  const long quarters = random.integer(-4, 4);
  return middle_of(ball) + radius_of(ball) * Rational(quarters, 4);
}

/// Arb rounds radii up to 30 bits and midpoints to the precision. So a radius may be wider than the
/// one that is due by 2^-20 of it, and by one rounding of the midpoint, or more where numbers in
/// between are rounded.
Rational allowed_radius(const Rational& due, const Rational& result, int roundings = 1) {
  const Rational rounding =
      result.abs() * Rational::power_of_two(1 - WorkingPrecision::bits()) * Rational(roundings);
  return (due + rounding) * (Rational(1) + Rational::power_of_two(-20));
}

bool is_as_tight_as(const Ball& result, const Rational& due, int roundings = 1) {
  const Rational largest = middle_of(result).abs() + radius_of(result);
  return radius_of(result) <= allowed_radius(due, largest, roundings);
}

TEST(Ball, SumsEncloseAndAreTight) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const WorkingPrecision precision(some_precision(random));
    const Ball a = random.ball(), b = random.ball();
    const Rational x = member(random, a), y = member(random, b);
    const Rational due = radius_of(a) + radius_of(b);
    ASSERT_TRUE((a + b).contains(x + y)) << i;
    ASSERT_TRUE((a - b).contains(x - y)) << i;
    ASSERT_TRUE((-a).contains(-x)) << i;
    ASSERT_TRUE(is_as_tight_as(a + b, due)) << i;
    ASSERT_TRUE(is_as_tight_as(a - b, due)) << i;
    ASSERT_EQ(radius_of(-a), radius_of(a)) << i;
  }
}

TEST(Ball, ProductsEncloseAndAreTight) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const WorkingPrecision precision(some_precision(random));
    const Ball a = random.ball(), b = random.ball();
    ASSERT_TRUE((a * b).contains(member(random, a) * member(random, b))) << i;
    const Rational due = middle_of(a).abs() * radius_of(b) + middle_of(b).abs() * radius_of(a) +
                         radius_of(a) * radius_of(b);
    ASSERT_TRUE(is_as_tight_as(a * b, due)) << i;
  }
}

TEST(Ball, QuotientsEncloseAndAreTight) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const WorkingPrecision precision(some_precision(random));
    const Ball a = random.ball(), b = random.ball();
    const Ball quotient = a / b;
    const Rational x = member(random, a), y = member(random, b);
    if (!y.is_zero()) {
      ASSERT_TRUE(quotient.contains(x / y)) << i;
    }
    if (b.contains_zero()) {
      ASSERT_FALSE(quotient.is_finite()) << i;
      continue;
    }
    // |x/y - a/b| <= (|a| r_b + |b| r_a) / (|b| (|b| - r_b)); twice that is no loose bound where
    // the divisor is narrow.
    const Rational p = middle_of(a).abs(), q = middle_of(b).abs(), r = radius_of(b);
    if (r * Rational(2) > q) continue;
    const Rational due = (p * r + q * radius_of(a)) / (q * (q - r));
    ASSERT_TRUE(is_as_tight_as(quotient, due * Rational(2))) << i;
  }
}

TEST(Ball, BothOperandsMayBeTheSame) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const WorkingPrecision precision(some_precision(random));
    const Ball value = random.ball(), copy = value;
    const Rational x = member(random, value);
    Ball a = value;
    a += a;
    ASSERT_EQ(a, value + copy) << i;
    ASSERT_TRUE(a.contains(x + x)) << i;
    a = value;
    a -= a;
    ASSERT_TRUE(a.contains(Rational(0))) << i;
    ASSERT_TRUE(is_as_tight_as(a, radius_of(value) * Rational(2))) << i;
    a = value;
    a *= a;
    ASSERT_TRUE(a.contains(x * x)) << i;
    ASSERT_TRUE(a.overlaps(value * copy)) << i;
    a = value;
    a /= a;
    ASSERT_EQ(a.is_finite(), !value.contains_zero()) << i;
    ASSERT_TRUE(a.contains(Rational(1))) << i;
  }
}

TEST(Ball, SurvivesAssignmentToItself) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const Ball value = random.ball();
    Ball a = value;
    Ball& same = a;
    a = same;
    ASSERT_EQ(a, value);
    a = std::move(same);
    ASSERT_EQ(a, value);
    std::swap(a, same);
    ASSERT_EQ(a, value);
    const Ball taken = std::move(a);
    ASSERT_EQ(taken, value);
    a = Ball(random.rational());  // what was moved from can be used again
    a += taken;
    ASSERT_EQ(taken, value) << "the two share nothing";
  }
}

TEST(Ball, EnclosesTheFractionItIsMadeFrom) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const WorkingPrecision precision(some_precision(random));
    const Rational x = random.rational(), r = random.rational().abs();
    ASSERT_TRUE(Ball(x).contains(x)) << i;
    ASSERT_TRUE(is_as_tight_as(Ball(x), Rational(0))) << i;
    const Ball around = Ball::around(x, r);
    ASSERT_TRUE(around.contains(x + r)) << i;
    ASSERT_TRUE(around.contains(x - r)) << i;
    ASSERT_TRUE(is_as_tight_as(around, allowed_radius(r, r) + allowed_radius(0, x))) << i;
  }
}

TEST(Ball, SeparatesAndComparesOnlyWhatIsProved) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const Ball a = random.ball(), b = random.ball();
    const Rational lower_a = middle_of(a) - radius_of(a), upper_a = middle_of(a) + radius_of(a);
    const Rational lower_b = middle_of(b) - radius_of(b), upper_b = middle_of(b) + radius_of(b);
    ASSERT_EQ(certainly_less(a, b), upper_a < lower_b) << i;
    ASSERT_EQ(a.overlaps(b), lower_a <= upper_b && lower_b <= upper_a) << i;
    ASSERT_EQ(a.contains(b), lower_a <= lower_b && upper_b <= upper_a) << i;
    ASSERT_EQ(a.contains_zero(), lower_a.sign() <= 0 && upper_a.sign() >= 0) << i;
    ASSERT_EQ(a.is_positive(), lower_a.sign() > 0) << i;
    ASSERT_EQ(a.is_exact(), radius_of(a).is_zero()) << i;
    const Ball both = hull(a, b);
    ASSERT_TRUE(both.contains(a) && both.contains(b)) << i;
    const Rational width = std::max(upper_a, upper_b) - std::min(lower_a, lower_b);
    ASSERT_TRUE(is_as_tight_as(both, width / Rational(2), 4)) << i;
  }
}

TEST(Ball, FunctionsEncloseAtEveryPrecision) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const Ball a =
        Ball::around(Rational(random.integer(-400, 400), 10), Rational(random.integer(0, 3), 7));
    const Ball point(member(random, a));
    const WorkingPrecision precision(some_precision(random));
    const auto exactly = [&](auto function) {
      const WorkingPrecision high(600);
      return function(point);
    };
    // The value at the point, at a high precision, is so narrow that it lies inside or does not.
    const auto holds = [&](auto function) { return function(a).overlaps(exactly(function)); };
    ASSERT_TRUE(holds([](const Ball& x) { return sqrt(abs(x)); })) << i;
    ASSERT_TRUE(holds([](const Ball& x) { return abs(x); })) << i;
    ASSERT_TRUE(holds([](const Ball& x) { return cos(x); })) << i;
    ASSERT_TRUE(holds([](const Ball& x) { return sin(x); })) << i;
    ASSERT_TRUE(holds([](const Ball& x) { return exp(x); })) << i;
    ASSERT_TRUE(holds([](const Ball& x) { return log(Ball(1) + abs(x)); })) << i;
    ASSERT_TRUE(holds([](const Ball& x) { return pow(x, 5); })) << i;
  }
}

TEST(Ball, FunctionsObeyTheirEquations) {
  RandomNumbers random;
  const WorkingPrecision precision(200);
  constexpr double narrow = 1e-40;
  for (int i = 0; i < 1000; ++i) {
    const Ball x(Rational(random.integer(1, 4000), 100));
    const std::pair<Ball, Ball> equations[] = {{sqrt(x) * sqrt(x), x},
                                               {cos(x) * cos(x) + sin(x) * sin(x), Ball(1)},
                                               {exp(log(x)), x},
                                               {pow(x, 3), x * x * x},
                                               {sin(x + Ball::pi()), -sin(x)},
                                               {abs(-x), x}};
    for (const auto& [left, right] : equations) {
      ASSERT_TRUE(left.overlaps(right)) << i;
      ASSERT_LT((left - right).radius_double(), narrow) << i;
    }
  }
}

TEST(Ball, DoublesAreRoundedAsSaid) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const Ball a = random.ball();
    const double middle = a.to_double();
    const Rational error = (exact_value(Ball::from_double(middle)) - middle_of(a)).abs();
    ASSERT_LE(error, middle_of(a).abs() * Rational::power_of_two(-53)) << i;
    ASSERT_GE(exact_value(Ball::from_double(a.radius_double())), radius_of(a)) << i;
    ASSERT_LE(a.radius_double(), 1.0001 * a.radius().to_double()) << i;
  }
  const Ball tiny = Ball::around(1, Rational::power_of_two(-2000));
  EXPECT_EQ(tiny.radius_double(), std::numeric_limits<double>::denorm_min()) << "an upper bound";
  EXPECT_TRUE(std::isinf(Ball(Rational::power_of_two(2000)).to_double()));
}

TEST(Ball, InfinitiesStayEnclosures) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Ball infinite = Ball::from_double(infinity);
  const Ball everything = Ball(1) / Ball(0);
  const Ball nothing_known = Ball::from_double(std::numeric_limits<double>::quiet_NaN());
  for (const Ball& ball : {infinite, everything, nothing_known}) {
    EXPECT_FALSE(ball.is_finite());
    EXPECT_FALSE((ball + Ball(1)).is_finite());
    EXPECT_FALSE((ball - ball).is_finite());
    EXPECT_FALSE((ball * Ball(2)).is_finite());
    EXPECT_FALSE((ball / ball).is_finite());
    Ball same = ball;
    same /= same;
    EXPECT_FALSE(same.is_finite());
  }
  EXPECT_TRUE(everything.contains(Rational(-7, 3)));
  EXPECT_TRUE((everything - everything).contains(Rational(0)));
  EXPECT_TRUE(certainly_less(Ball(1), infinite));
  EXPECT_FALSE(certainly_less(everything, infinite));
  EXPECT_FALSE(sqrt(Ball(-1)).is_finite());
  EXPECT_FALSE(log(Ball(0)).is_finite());
}

TEST(WorkingPrecision, LastsUntilTheEndOfItsScope) {
  const long before = WorkingPrecision::bits();
  {
    const WorkingPrecision outer(77);
    EXPECT_THROW(WorkingPrecision(1), std::invalid_argument);
    EXPECT_EQ(WorkingPrecision::bits(), 77);
    {
      const WorkingPrecision inner(99);
      EXPECT_EQ(WorkingPrecision::bits(), 99);
    }
    EXPECT_EQ(WorkingPrecision::bits(), 77);
  }
  EXPECT_EQ(WorkingPrecision::bits(), before);
}

}  // namespace
}  // namespace wavecurve::certified
