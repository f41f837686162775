#include "wavecurve/certified/user_filter.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"

namespace wavecurve::certified {
namespace {

UserFilter printed(const std::string& name, int digits) {
  const auto bank = find_filter(name).bank(400);
  const auto decimals = [digits](const Filter<Ball>& filter) {
    Filter<std::string> text{filter.first_index, {}};
    for (const Ball& tap : filter.taps) text.taps.push_back(*round_to_digits(tap, digits));
    return text;
  };
  UserFilter user;
  user.name = "mine";
  user.taps = decimals(bank.synthesis_low);
  if (!bank.is_orthonormal()) user.dual = decimals(bank.analysis_low);
  return user;
}

TEST(UserFilter, DecimalsEncloseTheFilterTheyWereRoundedFrom) {
  for (const char* name : {"db3", "sym8", "coif2", "cdf9.7", "bspline4.4"}) {
    const auto user = define_user_filter(printed(name, 30));
    const auto bank = user.bank(128), truth = find_filter(name).bank(400);
    EXPECT_EQ(bank.vanishing_moments, truth.vanishing_moments) << name;
    EXPECT_EQ(bank.dual_vanishing_moments, truth.dual_vanishing_moments) << name;
    for (std::size_t i = 0; i < truth.synthesis_low.taps.size(); ++i) {
      EXPECT_TRUE(bank.synthesis_low.taps[i].contains(truth.synthesis_low.taps[i])) << name;
    }
    const auto mu = connection_coefficients(user, 1, 1, 128).mu;
    const auto mu_truth = connection_coefficients(find_filter(name), 1, 1, 300).mu;
    for (int l = 0; l <= mu_truth.last_index(); ++l) {
      EXPECT_TRUE(mu[l].contains(mu_truth[l])) << name << " " << l;
    }
    EXPECT_LT(mu[0].radius_double(), 1e-20);  // 30 digits, less what the solve loses
  }
}

TEST(UserFilter, DecimalsStandForHalfAUnitEitherWay) {
  UserFilter user{"mine", {0, {"0.6830", "1.183", "31.70e-2", "-0.18301"}}, {}, "2", {}, {}};
  const double half_units[] = {0.5e-4, 0.5e-3, 0.5e-4, 0.5e-5};
  for (const auto& [sum, factor] :
       {std::pair{"2", std::sqrt(0.5)}, {"sqrt2", 1.0}, {"1", std::sqrt(2.0)}}) {
    user.sum = sum;
    user.taps.taps = {"0.6830", "1.183", "31.70e-2", "-0.18301"};
    // The taps of db2 have the sum 2; for another sum they are scaled.
    if (user.sum == "sqrt2") user.taps.taps = {"0.4830", "0.837", "22.41e-2", "-0.12941"};
    if (user.sum == "1") user.taps.taps = {"0.3415", "0.592", "15.85e-2", "-0.09151"};
    const Filter<Ball> low = define_user_filter(user).bank(128).synthesis_low;
    for (int i = 0; i < 4; ++i) {
      EXPECT_NEAR(low[i].radius_double() / (half_units[i] * factor), 1, 1e-6) << sum << " " << i;
    }
  }
}

TEST(UserFilter, ExactDecimalsAreExactNumbers) {
  UserFilter spline{"mine", {-1, {"0.25", "0.75", "0.75", "0.25"}}, {}, "2", {}, {}};
  spline.dual = {-1, {"-0.5", "1.5", "1.5", "-0.5"}};
  const auto definition = define_user_filter(spline);
  ASSERT_TRUE(definition.exact.has_value());
  EXPECT_EQ(definition.exact->synthesis, find_filter("bspline3.1").exact->synthesis);
  EXPECT_EQ(definition.exact->analysis, find_filter("bspline3.1").exact->analysis);
}

TEST(UserFilter, NamesTheRelationThatFails) {
  UserFilter wrong = printed("db3", 20);
  wrong.taps.taps[2] = "0.46";  // was 0.4598775...: half a unit of 0.005 holds it
  EXPECT_NO_THROW(define_user_filter(wrong));
  wrong.taps.taps[2] = "0.47";
  try {
    define_user_filter(wrong);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("sum_k synthesis_low_k = sqrt 2 by"),
              std::string::npos)
        << error.what();
  }
}

TEST(UserFilter, ChecksTheClaimedMoments) {
  UserFilter claim = printed("db3", 20);
  claim.vanishing_moments = 3;
  EXPECT_NO_THROW(define_user_filter(claim));
  claim.vanishing_moments = 4;
  EXPECT_THROW(define_user_filter(claim), std::invalid_argument);
  claim.vanishing_moments = -1;
  EXPECT_THROW(define_user_filter(claim), std::invalid_argument);
  claim.vanishing_moments = 3;
  claim.dual_vanishing_moments = -1;
  EXPECT_THROW(define_user_filter(claim), std::invalid_argument);
}

TEST(UserFilter, RefusesBadInput) {
  const auto with = [](auto change) {
    UserFilter user = printed("db2", 20);
    change(user);
    return user;
  };
  EXPECT_THROW(define_user_filter(with([](auto& u) { u.taps.taps.clear(); })),
               std::invalid_argument);
  EXPECT_THROW(define_user_filter(with([](auto& u) { u.taps.taps[0] = "x"; })),
               std::invalid_argument);
  EXPECT_THROW(define_user_filter(with([](auto& u) { u.sum = "3"; })), std::invalid_argument);
  EXPECT_THROW(define_user_filter(with([](auto& u) { u.taps.first_index = 20000; })),
               std::invalid_argument);
  EXPECT_THROW(define_user_filter(with([](auto& u) { u.taps.taps.assign(1001, "0.1"); })),
               std::invalid_argument);
  try {
    define_user_filter(with([](auto& u) { u.dual = Filter<std::string>{20000, {"1"}}; }));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "the first index of filter mine is 20000, but must be from -10000 to 10000");
  }
}

RC_GTEST_PROP(UserFilter, AnyTapMovedByMoreThanItsDigitsIsRefused, ()) {
  constexpr int digits = 12;
  UserFilter user = printed("db4", digits);
  const auto position = *rc::gen::inRange<std::size_t>(0, user.taps.taps.size());
  const Rational shift =
      Rational(*rc::gen::elementOf(std::vector<long>{-1, 1})) *
      Rational::from_decimal("1e-" + std::to_string(*rc::gen::inRange(1, digits - 2)));
  const Rational moved = Rational::from_decimal(user.taps.taps[position]) + shift;
  user.taps.taps[position] = round_to_digits(moved, digits);
  RC_ASSERT_THROWS_AS(define_user_filter(user), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::certified
