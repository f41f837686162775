#include "wavecurve/certified/user_filter.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/certified/sobolev_exponent.hpp"

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

std::string refusal(const UserFilter& user) {
  try {
    define_user_filter(user);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(UserFilter, ItsNameHasABound) {
  EXPECT_EQ(refusal({std::string(200, 'n'), {0, {"1", "1"}}, {}, "2"}), "");
  EXPECT_EQ(refusal({std::string(201, 'n'), {0, {"1", "1"}}, {}, "2"}),
            "the number of characters of the filter's name is 201, but must be from 0 to 200");
}

TEST(UserFilter, ZerosAreExactAndThoseAtTheEndsAreNoTaps) {
  UserFilter padded = printed("db3", 20);
  const UserFilter plain = padded;
  auto& taps = padded.taps.taps;
  taps.insert(taps.begin(), {"0.0", "0"});
  taps.insert(taps.end(), {"0.000", "-0e-3"});
  padded.taps.first_index = 7;
  const auto bank = define_user_filter(padded).bank(128);
  EXPECT_EQ(bank.synthesis_low.first_index, 9);
  EXPECT_EQ(bank.synthesis_low.taps, define_user_filter(plain).bank(128).synthesis_low.taps);
  EXPECT_EQ(bank.vanishing_moments, 3);
  UserFilter hole{"mine", {0, {"0.5", "0.00", "0.00", "0.5"}}, {}, "1", {}, {}};
  const auto low = define_user_filter(hole).bank(128).synthesis_low;
  EXPECT_TRUE(low.taps[1].is_exact() && low.taps[1].contains_zero());
  EXPECT_EQ(refusal({"mine", {0, {"0", "0.0"}}}),
            "the number of taps of filter mine is 0, but must be from 1 to 256");
}

TEST(UserFilter, EachSideHasItsSumAndTapsMayBeFractions) {
  // The pair 5/3 as JPEG 2000 prints it.
  UserFilter legall{"5/3", {-1, {"1/2", "1", "0.5"}}, {}, "2", {}, {}};
  legall.dual = {-2, {"-1/8", "2/8", "6/8", "0.25", "-0.125"}};
  EXPECT_NE(refusal(legall), "");
  legall.dual_sum = "1";
  const auto definition = define_user_filter(legall);
  ASSERT_TRUE(definition.exact.has_value());
  EXPECT_EQ(definition.exact->synthesis, find_filter("bspline2.2").exact->synthesis);
  EXPECT_EQ(definition.exact->analysis, find_filter("bspline2.2").exact->analysis);
  EXPECT_FALSE(definition.known_bits || definition.dual_known_bits);
  legall.taps.taps[1] = "1/0";
  EXPECT_EQ(refusal(legall), "taps[1] of filter 5/3: '1/0' is divided by zero");
}

TEST(UserFilter, TheStatedAccuracyIsTheRadius) {
  UserFilter user = printed("db2", 20);
  user.accuracy = "3e-7";
  const auto definition = define_user_filter(user);
  for (const Ball& tap : definition.bank(128).synthesis_low.taps) {
    EXPECT_NEAR(tap.radius_double() / 3e-7, 1, 1e-6);
  }
  EXPECT_NEAR(static_cast<double>(*definition.known_bits), -std::log2(3e-7), 1);
  for (const char* bad : {"0", "-1e-3", "1", "x"}) {
    user.accuracy = bad;
    EXPECT_THROW(define_user_filter(user), std::invalid_argument) << bad;
  }
  UserFilter pair = printed("cdf9.7", 20);
  pair.accuracy = "1e-3";
  pair.dual_accuracy = "1e-5";
  const auto bank = define_user_filter(pair).bank(128);
  EXPECT_NEAR(bank.synthesis_low.taps[0].radius_double(), 1e-3, 1e-8);
  EXPECT_NEAR(bank.analysis_low.taps[0].radius_double(), 1e-5, 1e-10);
}

// Filters as PyWavelets prints them, made in double arithmetic.
const Filter<std::string> sym4_in_doubles{
    -3,
    {"0.0322231006040427", "-0.012603967262037833", "-0.09921954357684722", "0.29785779560527736",
     "0.8037387518059161", "0.49761866763201545", "-0.02963552764599851", "-0.07576571478927333"}};
const Filter<std::string> cdf97_synthesis_in_doubles{
    -3,
    {"-0.06453888262869706", "-0.04068941760916406", "0.41809227322161724", "0.7884856164055829",
     "0.41809227322161724", "-0.04068941760916406", "-0.06453888262869706"}};
const Filter<std::string> cdf97_analysis_in_doubles{
    -4,
    {"0.03782845550726404", "-0.023849465019556843", "-0.11062440441843718", "0.37740285561283066",
     "0.8526986790088938", "0.37740285561283066", "-0.11062440441843718", "-0.023849465019556843",
     "0.03782845550726404"}};

TEST(UserFilter, SaysWhichAccuracyWouldBeAcceptedAndTheTruthIsWithin) {
  UserFilter sym4{"mine", sym4_in_doubles}, cdf97{"mine", cdf97_synthesis_in_doubles};
  cdf97.dual = cdf97_analysis_in_doubles;
  for (const auto& [user, name, worst] :
       {std::tuple{sym4, "sym4", 1e-10}, std::tuple{cdf97, "cdf9.7", 1e-11}}) {
    const std::string message = refusal(user);
    const std::string opening = "with \"accuracy\": \"";
    const auto place = message.find(opening);
    ASSERT_NE(place, std::string::npos) << message;
    UserFilter again = user;
    again.accuracy = message.substr(place + opening.size());
    again.accuracy->resize(again.accuracy->find('"'));
    EXPECT_LT(std::stod(*again.accuracy), worst) << message;
    const auto definition = define_user_filter(again);
    const auto truth = find_filter(name);
    EXPECT_EQ(definition.bank(128).vanishing_moments, truth.bank(128).vanishing_moments);
    const auto mu = connection_coefficients(definition, 1, 1, 128).mu;
    const auto mu_truth = connection_coefficients(truth, 1, 1, 200).mu;
    for (int l = 0; l <= mu_truth.last_index(); ++l) EXPECT_TRUE(mu[l].contains(mu_truth[l])) << l;
  }
}

// The nearest doubles are off by more than their digits say, now and then: then the table is refused,
// and not taken for another filter with fewer zeros at pi.
TEST(UserFilter, TablesOfDoublesHaveTheZerosThatAreMeant) {
  int refused = 0;
  for (const std::string name : {"db3", "db6", "db9", "db13", "db20", "db31", "sym10", "coif3"}) {
    const auto truth = find_filter(name).bank(200);
    UserFilter user{name, {truth.synthesis_low.first_index, {}}};
    for (const Ball& tap : truth.synthesis_low.taps) {
      user.taps.taps.push_back(fmt::format("{}", *round_to_double(tap)));
    }
    const std::string message = refusal(user), opening = "with \"accuracy\": \"";
    if (!message.empty()) {
      ++refused;
      const auto place = message.find(opening);
      ASSERT_NE(place, std::string::npos) << message;
      user.accuracy = message.substr(place + opening.size());
      user.accuracy->resize(user.accuracy->find('"'));
      EXPECT_LT(std::stod(*user.accuracy), 1e-15) << message;
    }
    const auto definition = define_user_filter(user);
    EXPECT_EQ(definition.bank(128).vanishing_moments, truth.vanishing_moments) << name;
    EXPECT_NO_THROW(require_smoothness(definition, 1, 1)) << name;
    const Ball s = sobolev_exponent(definition), s_truth = sobolev_exponent(find_filter(name));
    EXPECT_TRUE(s.overlaps(s_truth)) << name;
  }
  EXPECT_GT(refused, 0);
}

// H(pi)^2 = 2 - H(0)^2 of orthonormal taps: a residual of 1e-9 there is one of 1e-18 in their norm.
TEST(UserFilter, OrthonormalTapsHaveAZeroAtPi) {
  const UserFilter user{"mine", {0, {"0.70710678168654752", "0.70710678068654752"}}};
  const std::string message = refusal(user);
  EXPECT_TRUE(message.starts_with("filter mine violates sum_k (-1)^k k^0 synthesis_low_k = 0 by"))
      << message;
  EXPECT_TRUE(message.ends_with("with \"accuracy\": \"6e-10\" it would be accepted")) << message;
}

TEST(UserFilter, AFilterThatIsNoneGetsNoAccuracy) {
  UserFilter none{"mine", {0, {"0.9", "0.4", "0.1", "0.3"}}};
  EXPECT_EQ(refusal(none).find("accuracy"), std::string::npos) << refusal(none);
  EXPECT_NE(refusal(none).find("more than its digits explain"), std::string::npos);
}

// Beylkin's filter of 18 taps to 12 decimals.
TEST(UserFilter, TwelveDigitsOfBeylkinsFilterGiveNineOfItsStiffness) {
  const std::vector<std::string> decimals{
      "0.099305765374",  "0.424215360813",  "0.699825214057",  "0.449718251149",  "-0.110927598348",
      "-0.264497231446", "0.026900308804",  "0.155538731877",  "-0.017520746267", "-0.088543630623",
      "0.019679866044",  "0.042916387274",  "-0.017460408696", "-0.014365807969", "0.010040411845",
      "0.001484234782",  "-0.002736031626", "0.000640485329"};
  const auto mu =
      connection_coefficients(define_user_filter({"beylkin", {0, decimals}}), 1, 1, 128);
  EXPECT_LT(mu.mu[0].radius_double(), 1e-10);
  EXPECT_LT(mu.nu[0].radius_double(), 1e-8);
  EXPECT_NEAR(mu.mu[0].to_double(), 3.4059476131, 2e-10);  // by the table of 15 decimals
}

// A filter of a family, printed with errors up to the accuracy that is stated.
RC_GTEST_PROP(UserFilter, TheResultsEncloseThoseOfTheFilterThatWasMeant, ()) {
  const std::string name = *rc::gen::elementOf(
      std::vector<std::string>{"db3", "db7", "sym6", "coif2", "cdf9.7", "bspline3.3"});
  const auto truth = find_filter(name);
  const int digits = *rc::gen::inRange(9, 30);
  UserFilter user = printed(name, digits + 10);
  user.accuracy = "1e-" + std::to_string(digits);
  const auto disturb = [&](Filter<std::string>& filter) {
    for (std::string& tap : filter.taps) {
      if (tap == "0") continue;
      const Rational error =
          Rational::from_decimal(*user.accuracy) * Rational(*rc::gen::inRange(-99L, 100L), 100);
      tap = round_to_digits(Rational::from_decimal(tap) + error, digits + 10);
    }
  };
  disturb(user.taps);
  if (user.dual) disturb(*user.dual);
  const auto definition = define_user_filter(user);
  const auto found = connection_coefficients(definition, 1, 1, 128);
  const auto expected = connection_coefficients(truth, 1, 1, 300);
  for (int l = 0; l <= expected.mu.last_index(); ++l) {
    RC_ASSERT(found.mu[l].contains(expected.mu[l]));
  }
  for (int l = 0; l <= expected.nu.last_index(); ++l) {
    RC_ASSERT(found.nu[l].contains(expected.nu[l]));
  }
  RC_ASSERT(sobolev_exponent(definition).overlaps(sobolev_exponent(truth)));
}

}  // namespace
}  // namespace wavecurve::certified
