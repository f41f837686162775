#include "wavecurve/certified/sobolev_exponent.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"

namespace wavecurve::certified {
namespace {

TEST(SobolevExponent, OfSplinesIsTheOrderLessAHalf) {
  for (int order = 1; order <= 9; ++order) {
    const Ball s = sobolev_exponent(
        find_filter("bspline" + std::to_string(order) + "." + std::to_string(order)));
    EXPECT_TRUE(s.contains(Rational(2 * order - 1, 2))) << order;
    EXPECT_LT(s.radius_double(), 1e-12);
  }
}

TEST(SobolevExponent, OfDb2IsExactlyOne) {
  const Ball s = sobolev_exponent(find_filter("db2"));
  EXPECT_TRUE(s.contains(Rational(1)));
  EXPECT_LT(s.radius_double(), 1e-12);
}

TEST(SobolevExponent, OfDb3HasItsClosedForm) {
  // |q|^2 = 1 + 3y + 6y^2 has the cosine coefficients 19/4, -9/4, 3/8, so that T = [[19/2, -9],
  // [3/4, -9/2]] with the characteristic polynomial x^2 - 5x - 36 and rho = 9: s = 3 - log_4 9.
  const WorkingPrecision precision(128);
  const Ball s = sobolev_exponent(find_filter("db3"));
  EXPECT_TRUE(s.overlaps(Ball(3) - log(Ball(9)) / log(Ball(4))));
  EXPECT_LT(s.radius_double(), 1e-12);
}

TEST(SobolevExponent, IsEnclosedByAnyNumberOfSquarings) {
  const WorkingPrecision precision(256);
  const FilterBank<Ball> db3 = find_filter("db3").bank(256);
  const Ball truth = Ball(3) - log(Ball(9)) / log(Ball(4));
  double last = 10;
  for (int squarings = 0; squarings <= 6; ++squarings) {
    const Ball s = sobolev_exponent(db3.synthesis_low, 3, squarings);
    EXPECT_TRUE(s.contains(truth)) << squarings;
    EXPECT_LT(s.radius_double(), last) << squarings;
    last = s.radius_double();
  }
}

TEST(SobolevExponent, MatchesThePublishedFigures) {
  // db N by Villemoes and others, to three decimals.
  const std::pair<const char*, double> known[] = {
      {"db3", 1.415}, {"db4", 1.776}, {"coif1", 1.022}, {"coif2", 1.836}, {"db10", 3.403}};
  for (const auto& [name, value] : known) {
    EXPECT_NEAR(sobolev_exponent(find_filter(name)).to_double(), value, 0.0005) << name;
  }
}

TEST(SobolevExponent, OfTheDualMayBeNegative) {
  EXPECT_LT(sobolev_exponent(dual(find_filter("bspline3.1"))).to_double(), 0);
  const Ball dual_of_dual = sobolev_exponent(dual(dual(find_filter("cdf9.7"))));
  EXPECT_TRUE(dual_of_dual.overlaps(sobolev_exponent(find_filter("cdf9.7"))));
}

TEST(SobolevExponent, RefusesAFilterWithoutTheZeros) {
  const auto low = find_filter("db3").bank(128).synthesis_low;
  EXPECT_THROW(sobolev_exponent(low, 4, 10), std::domain_error);
}

TEST(RequireSmoothness, DrawsTheLineAtTheExponent) {
  EXPECT_NO_THROW(require_smoothness(find_filter("coif1"), 1, 1));  // 1.022 > 1
  EXPECT_THROW(require_smoothness(find_filter("db2"), 1, 1), std::domain_error);
  EXPECT_NO_THROW(require_smoothness(find_filter("db2"), 0, 1));
  EXPECT_THROW(require_smoothness(find_filter("coif1"), 2, 1), std::domain_error);
}

}  // namespace
}  // namespace wavecurve::certified
