#include "wavecurve/certified/detail/eigenfunction_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace wavecurve::certified {
namespace {

double value_at(const std::vector<Ball>& u, double w) {
  double sum = u[0].to_double();
  for (std::size_t k = 1; k < u.size(); ++k) {
    sum += 2 * u[k].to_double() * std::cos(static_cast<double>(k) * w);
  }
  return sum;
}

/// u and its least value on a grid.
double minimum_on_grid(const std::vector<Ball>& u) {
  double least = HUGE_VAL;
  for (int i = 0; i <= 2000; ++i)
    least = std::min(least, value_at(u, i * (std::numbers::pi / 2000)));
  return least;
}

// |p(e^iw)|^2 + c is positive, and close to c where p has a zero near the circle.
std::vector<Ball> square_plus(const std::vector<double>& p, double c) {
  std::vector<Ball> u(p.size(), Ball(0));
  for (std::size_t k = 0; k < p.size(); ++k) {
    for (std::size_t i = 0; i + k < p.size(); ++i) {
      u[k] += Ball::from_double(p[i]) * Ball::from_double(p[i + k]);
    }
  }
  u[0] += Ball::from_double(c);
  return u;
}

TEST(PositiveMinimum, IsALowerBoundThatIsNearTheMinimum) {
  const WorkingPrecision precision(128);
  for (const double c : {1.0, 1e-2, 1e-4}) {
    for (const auto& p :
         {std::vector<double>{1, -1}, {1, 0.5, -2, 0.3}, {1, 2, 3, 2, 1, -4, 1, 1}}) {
      const std::vector<Ball> u = square_plus(p, c);
      const auto bound = positive_minimum(u);
      ASSERT_TRUE(bound) << c;
      EXPECT_LE(bound->to_double(), minimum_on_grid(u) * (1 + 1e-12));  // the sums are rounded
      EXPECT_GT(bound->to_double(), 0);
    }
  }
}

TEST(PositiveMinimum, IsRefusedWhereTheFunctionIsNegativeOrZero) {
  const WorkingPrecision precision(128);
  EXPECT_FALSE(positive_minimum(square_plus({1, -1}, -1e-3)));
  EXPECT_FALSE(positive_minimum(square_plus({1, -2, 1}, 0)));    // 0 at w = 0
  EXPECT_FALSE(positive_minimum({Ball(1), Ball(1), Ball(-1)}));  // negative inside
}

// T of |q|^2 = 1 + 3y + 6y^2 (db3) is [[19/2, -9], [3/4, -9/2]]: x^2 - 5x - 36 has the root 9.
TEST(SpectralRadius, IsTheLargestRootForDb3) {
  const WorkingPrecision precision(192);
  SquareMatrix<Ball> t(2);
  t(0, 0) = Ball(Rational(19, 2));
  t(0, 1) = Ball(-9);
  t(1, 0) = Ball(Rational(3, 4));
  t(1, 1) = Ball(Rational(-9, 2));
  const auto rho = spectral_radius_by_eigenfunction(t);
  ASSERT_TRUE(rho);
  EXPECT_TRUE(rho->contains(Rational(9)));
  EXPECT_LT(rho->radius_double(), 1e-40);
}

TEST(SpectralRadius, IsAsWideAsTheEntries) {
  const WorkingPrecision precision(192);
  SquareMatrix<Ball> t(1);
  t(0, 0) = Ball::around(Rational(3), Rational(1, 1000));
  const auto rho = spectral_radius_by_eigenfunction(t);
  ASSERT_TRUE(rho);
  EXPECT_TRUE(rho->contains(Rational(3)));
  EXPECT_TRUE(rho->contains(Rational(30009, 10000)));
  EXPECT_GE(rho->radius_double(), 1e-3);
  EXPECT_LT(rho->radius_double(), 1e-2);
}

}  // namespace
}  // namespace wavecurve::certified
