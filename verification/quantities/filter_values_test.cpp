#include "verification/quantities/filter_values.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

using certified::Ball;
using certified::Rational;

FilterValues values_of(const std::string& filter) {
  return FilterValues(find_table_filter(filter));
}

TEST(FilterValues, ListsTheTapsInEveryNormalization) {
  FilterValues values = values_of("K2");
  EXPECT_EQ(values.name(), "coif2");
  EXPECT_EQ(values.first_tap(), -4);
  EXPECT_EQ(values.number_of_taps(), 12);
  const auto sum = [&values](const Quantity& quantity) {
    double result = 0;
    for (int n = -4; n <= 7; ++n) result += values.value(quantity, n).to_double();
    return result;
  };
  EXPECT_NEAR(sum(Quantity::taps), std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(sum(Quantity::taps_sum_1), 1, 1e-14);
  EXPECT_NEAR(sum(Quantity::taps_sum_2), 2, 1e-14);
}

TEST(FilterValues, KnowsWhatIsZeroByStructure) {
  for (const char* filter : {"D8", "K2"}) {
    FilterValues values = values_of(filter);
    const int support = values.number_of_taps() - 1;
    EXPECT_TRUE(values.value(Quantity::autocorrelation, 2).is_exactly_zero());
    EXPECT_TRUE(values.value(Quantity::mu_normalized, support).is_exactly_zero());
    EXPECT_TRUE(values.value(Quantity::nu, support + 1).is_exactly_zero());
    EXPECT_FALSE(values.value(Quantity::mu, support - 1).is_exactly_zero());
    EXPECT_FALSE(values.value(Quantity::autocorrelation, 3).is_exactly_zero());
  }
}

TEST(FilterValues, AgreesWithTheRelationBetweenTheQuantities) {
  for (const char* filter : {"D8", "K2", "bspline4.4"}) {
    FilterValues values = values_of(filter);
    const double mu0 = values.value(Quantity::mu, 0).to_double();
    for (int l = 0; l < values.number_of_taps(); ++l) {
      EXPECT_NEAR(values.value(Quantity::mu, l).to_double(),
                  mu0 * values.value(Quantity::mu_normalized, -l).to_double(), 1e-14 * mu0);
    }
  }
  FilterValues values = values_of("D8");
  for (int l = 0; l < 7; ++l) {  // (3.14)
    const double mu_2l = 2 * l < 7 ? values.value(Quantity::mu, 2 * l).to_double() : 0;
    EXPECT_NEAR(values.value(Quantity::nu, l).to_double(),
                8 * mu_2l - values.value(Quantity::mu, l).to_double(), 1e-12);
  }
}

TEST(FilterValues, RefusesAnIndexBeyondTheFilter) {
  FilterValues values = values_of("K2");
  EXPECT_THROW(values.value(Quantity::taps, -5), std::domain_error);
  EXPECT_THROW(values.value(Quantity::taps_sum_1, 8), std::domain_error);
  EXPECT_THROW(values.value(Quantity::autocorrelation, 12), std::domain_error);
  EXPECT_NO_THROW(values.value(Quantity::autocorrelation, -11));
  EXPECT_NO_THROW(values.value(Quantity::mu, -12));
  EXPECT_THROW(values.value(Quantity::mu, 13), std::domain_error);
  EXPECT_THROW(values.value(Quantity::nu_normalized, -13), std::domain_error);
}

TEST(FilterValues, RefusesIntegralsThatDoNotExist) {
  FilterValues values = values_of("db2");
  EXPECT_NO_THROW(values.value(Quantity::autocorrelation, 1));
  EXPECT_THROW(values.value(Quantity::mu, 0), std::domain_error);
}

}  // namespace
}  // namespace wavecurve::verification
