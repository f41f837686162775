#include "wavecurve/certified/sobolev_exponent.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/certified/user_filter.hpp"

namespace wavecurve::certified {
namespace {

TEST(SobolevExponent, IsTheOrderLessAHalfForSplines) {
  for (int order = 1; order <= 9; ++order) {
    const Ball s = sobolev_exponent(
        find_filter("bspline" + std::to_string(order) + "." + std::to_string(order)));
    EXPECT_TRUE(s.contains(Rational(2 * order - 1, 2))) << order;
    EXPECT_LT(s.radius_double(), 1e-12);
  }
}

TEST(SobolevExponent, IsExactlyOneForDb2) {
  const Ball s = sobolev_exponent(find_filter("db2"));
  EXPECT_TRUE(s.contains(Rational(1)));
  EXPECT_LT(s.radius_double(), 1e-12);
}

TEST(SobolevExponent, HasAClosedFormForDb3) {
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

// The eigenfunction and the squarings are two ways to the same number.
TEST(SobolevExponent, IsTheSameByEigenfunctionAndBySquaring) {
  for (const char* name :
       {"db2", "db7", "db20", "sym8", "coif3", "coif9", "bspline3.5", "cdf9.7"}) {
    const FilterDefinition definition = find_filter(name);
    const WorkingPrecision precision(512);
    const FilterBank<Ball> bank = definition.bank(512);
    const Ball by_squaring = sobolev_exponent(bank.synthesis_low, bank.vanishing_moments, 30);
    const Ball found = sobolev_exponent(definition);
    EXPECT_TRUE(found.overlaps(by_squaring)) << name;
    EXPECT_LT(by_squaring.radius_double(), 1e-7) << name;
    EXPECT_LT(found.radius_double(), 1e-13) << name;
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

TEST(SobolevExponent, MayBeNegativeForTheDual) {
  EXPECT_LT(sobolev_exponent(dual(find_filter("bspline3.1"))).to_double(), 0);
  const Ball dual_of_dual = sobolev_exponent(dual(dual(find_filter("cdf9.7"))));
  EXPECT_TRUE(dual_of_dual.overlaps(sobolev_exponent(find_filter("cdf9.7"))));
}

TEST(SobolevExponent, RefusesAFilterWithoutTheZeros) {
  const auto low = find_filter("db3").bank(128).synthesis_low;
  EXPECT_THROW(sobolev_exponent(low, 4, 10), std::domain_error);
}

/// Taps 1 and 1, n intervals apart, n odd: phi is a box over all of them, whose shifts are no Riesz
/// basis, and the transition operator has eigenvalues of the cycles of w -> 2w.
FilterDefinition box_over(int n) {
  UserFilter lazy{"lazy", {0, std::vector<std::string>(static_cast<std::size_t>(n) + 1, "0")}};
  lazy.taps.taps.front() = lazy.taps.taps.back() = "1";
  lazy.sum = "2";
  return define_user_filter(lazy);
}

// The work is bounded: without that the last took minutes.
TEST(SobolevExponent, IsEnclosedInBoundedWorkForManyTaps) {
  // With n a multiple of 3 the cycle of 2 pi / 3 has |q|^2 = 4 at both of its points: rho = 4.
  for (const int n : {9, 45, 99, 195}) {
    const Ball s = sobolev_exponent(box_over(n));
    EXPECT_TRUE(s.contains(Rational(0))) << n;
    EXPECT_LT(s.radius_double(), n < 50 ? 1e-12 : 0.5) << n;
    EXPECT_FALSE(is_proved_smoother(box_over(n), Rational(0))) << n;
  }
}

TEST(SobolevExponent, IsAsAccurateAsTheTapsAllow) {
  UserFilter user{"mine",
                  {0,
                   {"0.332670552950", "0.806891509311", "0.459877502118", "-0.135011020010",
                    "-0.085441273882", "0.035226291886"}}};
  const WorkingPrecision precision(128);
  const Ball truth = Ball(3) - log(Ball(9)) / log(Ball(4));
  double last = 0;
  for (const char* accuracy : {"1e-12", "1e-9", "1e-6", "1e-4"}) {
    user.accuracy = accuracy;
    const Ball s = sobolev_exponent(define_user_filter(user));
    EXPECT_TRUE(s.contains(truth)) << accuracy;
    EXPECT_GT(s.radius_double(), last) << accuracy;
    last = s.radius_double();
  }
  EXPECT_LT(last, 0.5);
}

// With all zeros divided out, the errors of these are multiplied by 2^30, and nothing is known.
TEST(SobolevExponent, IsKnownForALongTableByTheZerosThatItTakes) {
  const auto truth = find_filter("db30");
  UserFilter user{"mine", {0, {}}};
  for (const Ball& tap : truth.bank(200).synthesis_low.taps) {
    user.taps.taps.push_back(*round_to_digits(tap, 17));
  }
  const Ball s = sobolev_exponent(define_user_filter(user));
  EXPECT_TRUE(s.overlaps(sobolev_exponent(truth)));
  EXPECT_TRUE(certainly_less(Ball(4), s));
  EXPECT_TRUE(is_proved_smoother(define_user_filter(user), Rational(1)));
}

TEST(RequireSmoothness, SaysWhenItIsNotKnown) {
  const UserFilter rough{"mine", {0, {"0.5", "0.8", "0.2", "-0.1"}}};
  try {
    require_smoothness(define_user_filter(rough), 1, 1);
    FAIL();
  } catch (const std::domain_error& error) {
    EXPECT_NE(std::string(error.what()).find("its taps have too few digits"), std::string::npos)
        << error.what();
  }
}

TEST(RequireSmoothness, DrawsTheLineAtTheExponent) {
  EXPECT_NO_THROW(require_smoothness(find_filter("coif1"), 1, 1));  // 1.022 > 1
  EXPECT_THROW(require_smoothness(find_filter("db2"), 1, 1), std::domain_error);
  EXPECT_NO_THROW(require_smoothness(find_filter("db2"), 0, 1));
  EXPECT_THROW(require_smoothness(find_filter("coif1"), 2, 1), std::domain_error);
}

}  // namespace
}  // namespace wavecurve::certified
