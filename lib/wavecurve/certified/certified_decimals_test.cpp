#include "wavecurve/certified/certified_decimals.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/certified/user_filter.hpp"

namespace wavecurve::certified {
namespace {

TEST(CertifiedDecimals, OneCallGivesProvedDigits) {
  EXPECT_EQ(certified_decimals(find_filter("coif2"), {.digits = 20}).mu[0].value,
            "4.0722079003268757404");
  const auto exact = certified_decimals(find_filter("D8")).mu[0];
  EXPECT_EQ(exact.exact, "342643/82248");
}

TEST(CertifiedDecimals, EveryValueIsTheRoundingOfAMuchNarrowerEnclosure) {
  constexpr long many_bits = 1000;
  const WorkingPrecision precision(many_bits);
  for (const char* name : {"coif2", "coif4", "cdf9.7", "db5", "bspline4.4"}) {
    const auto definition = find_filter(name);
    const auto truth = connection_coefficients(definition, 1, 1, many_bits);
    for (const int digits : {1, 7, 40, 150}) {
      const auto decimals = certified_decimals(definition, {.digits = digits});
      const auto expect_rounded = [&](const auto& column, const Filter<Ball>& values) {
        ASSERT_EQ(static_cast<int>(column.size()), values.last_index() + 1);
        for (int l = 0; l <= values.last_index(); ++l) {
          const auto& [value, radius, exact] = column[static_cast<std::size_t>(l)];
          if (exact == "0") continue;
          EXPECT_EQ(value, round_to_digits(values[l], digits)) << name << " " << l;
          const Ball error = abs(values[l] - Ball(Rational::from_decimal(value)));
          EXPECT_FALSE(certainly_less(Ball(Rational::from_decimal(radius)), error));
        }
      };
      expect_rounded(decimals.mu, truth.mu);
      expect_rounded(decimals.nu, truth.nu);
    }
  }
}

TEST(CertifiedDecimals, AreDividedByTheFirstOnRequest) {
  const auto rational = certified_decimals(find_filter("db3"), {.divide_by_first = true});
  EXPECT_EQ(rational.mu[0].exact, "1");
  EXPECT_EQ(rational.mu[4].exact, "-3/2950");
  EXPECT_EQ(rational.alpha[0].exact, "2") << "alpha stays as it is";
  const auto definition = find_filter("coif1");
  const auto mu = connection_coefficients(definition, 1, 1, 300).mu;
  const auto decimals = certified_decimals(definition, {.digits = 30, .divide_by_first = true});
  EXPECT_EQ(decimals.mu[2].value, round_to_digits(mu[2] / mu[0], 30));
}

TEST(CertifiedDecimals, UserDecimalsGiveWhatTheySupport) {
  UserFilter user;
  user.name = "own";
  user.sum = "sqrt2";
  const auto bank = find_filter("db4").bank(200);
  user.taps.first_index = bank.synthesis_low.first_index;
  for (const Ball& tap : bank.synthesis_low.taps) {
    user.taps.taps.push_back(*round_to_decimals(tap, 25));
  }
  user.vanishing_moments = bank.vanishing_moments;
  const auto own = certified_decimals(define_user_filter(user), {.digits = 500});
  const Rational truth = exact_connection_coefficients(find_filter("db4"), 1, 1)->mu[0];
  const Rational error = (truth - Rational::from_decimal(own.mu[0].value)).abs();
  const Rational radius = Rational::from_decimal(own.mu[0].radius);
  EXPECT_LE(error, radius);
  // The solve loses about six digits of the 25; two more are for the rounding.
  EXPECT_LT(radius, Rational::from_decimal("1e-17"));
  EXPECT_LT(own.mu[0].value.size(), 30U) << "no digit that is not proved";
}

std::string refusal(const char* name, const DecimalsRequest& request) {
  try {
    certified_decimals(find_filter(name), request);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CertifiedDecimals, RefuseBadInput) {
  EXPECT_EQ(refusal("db4", {.digits = 0}),
            "number of significant digits is 0, but must be at least 1");
  EXPECT_EQ(refusal("db4", {.p = 9}), "derivative order is 9, but must be from 0 to 8");
  EXPECT_EQ(refusal("db4", {.p = 0, .divide_by_first = true}),
            "the coefficient of index 0 is zero for the odd sum 1 of derivative orders, and "
            "nothing can be divided by it");
  EXPECT_THROW(certified_decimals(find_filter("db2")), std::domain_error);
  EXPECT_THROW(certified_decimals(find_filter("coif1"), {.p = 2, .q = 2}), std::domain_error);
}

}  // namespace
}  // namespace wavecurve::certified
