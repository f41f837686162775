#include "wavecurve/certified/integrals/exact_integrals.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/integrals/integral_decimals.hpp"
#include "wavecurve/certified/integrals/product_integrals.hpp"
#include "wavecurve/certified/user_filter.hpp"

namespace wavecurve::certified {
namespace {

constexpr BasisFunction phi{}, psi{.wavelet = true}, slope{.derivative = 1};

struct ExactCase {
  std::string filter;
  ProductIntegral integral;
};

std::vector<ExactCase> exact_cases() {
  const ProductIntegral three{{{phi, false}, {phi}, {phi}}};
  const ProductIntegral with_slope{{{slope, false}, {phi}, {phi}}};
  const ProductIntegral four{{{phi, false}, {phi}, {psi}, {phi}}};
  const ProductIntegral weighted{{{phi, false}, {slope}}, 2};
  const ProductIntegral on_half{{{phi}, {slope}}, 1, DyadicInterval{0, 1, 1}};
  const ProductIntegral finer{{{phi, false}, {psi, true, 1}}};
  ProductIntegral periodic = with_slope;
  periodic.period = 3;
  return {{"haar", three},           {"haar", four},           {"bspline2.2", with_slope},
          {"bspline2.2", four},      {"bspline3.1", weighted}, {"bspline2.2", on_half},
          {"bspline2.2", finer},     {"bspline2.2", periodic}, {"rbio2.2", finer},
          {"bspline4.4", with_slope}};
}

// The fractions lie in the enclosures, which another system solver has proved.
TEST(ExactIntegrals, FractionsLieInTheEnclosures) {
  for (const auto& [filter, integral] : exact_cases()) {
    SCOPED_TRACE(filter + ", " + name_of(integral));
    const FilterDefinition definition = find_filter(filter);
    const auto exact = exact_product_integrals(definition, integral);
    ASSERT_TRUE(exact);
    const ShiftTensor<Ball> enclosed = product_integrals(definition, integral, 128);
    ASSERT_EQ(exact->first, enclosed.first);
    ASSERT_EQ(exact->sizes, enclosed.sizes);
    for (std::size_t place = 0; place < exact->values.size(); ++place) {
      EXPECT_TRUE(enclosed.values[place].contains(exact->values[place]));
      EXPECT_LT(enclosed.values[place].radius_double(), 1e-25);
    }
  }
}

// hat(x)^3 is integrated by hand: 2 int_0^1 x^3 dx; hat^2(x) hat(x - 1): int_0^1 (1 - x)^2 x dx.
TEST(ExactIntegrals, ThreeHats) {
  const ProductIntegral three{{{phi, false}, {phi}, {phi}}};
  const auto exact = exact_product_integrals(find_filter("bspline2.2"), three);
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->at({0, 0}), Rational(1, 2));
  EXPECT_EQ(exact->at({0, 1}), Rational(1, 12));
  EXPECT_EQ(exact->at({1, -1}), Rational(0));
}

TEST(ExactIntegrals, AUsersOwnExactTaps) {
  UserFilter user;
  user.name = "hat";
  user.taps = {-1, {"0.5", "1", "0.5"}};
  user.dual = Filter<std::string>{-2, {"-0.25", "0.5", "1.5", "0.5", "-0.25"}};
  user.sum = "2";
  const ProductIntegral three{{{phi, false}, {phi}, {phi}}};
  const auto own = exact_product_integrals(define_user_filter(user), three);
  const auto listed = exact_product_integrals(find_filter("bspline2.2"), three);
  ASSERT_TRUE(own && listed);
  EXPECT_EQ(own->values, listed->values);
}

TEST(ExactIntegrals, NoneWhereTheTapsAreIrrationalOrTheSystemIsLarge) {
  const ProductIntegral three{{{phi, false}, {phi}, {phi}}};
  EXPECT_FALSE(exact_product_integrals(find_filter("db3"), three));
  EXPECT_FALSE(exact_product_integrals(find_filter("bspline20.2"), three));
}

TEST(ExactIntegrals, AreRefusedWhereTheyDoNotExist) {
  const ProductIntegral slopes{{{slope, false}, {slope}, {phi}}};
  EXPECT_THROW(exact_product_integrals(find_filter("haar"), slopes), std::domain_error);
}

TEST(ExactIntegrals, DecimalsCarryTheFractions) {
  const ProductIntegral with_slope{{{slope, false}, {phi}, {phi}}};
  for (const auto& entry : integral_decimals(find_filter("bspline2.2"), with_slope, 20)) {
    EXPECT_TRUE(entry.number.exact);
    EXPECT_NE(entry.number.exact, "0");
  }
  // All of these vanish, and one is listed.
  const ProductIntegral none{{{phi, false}, {psi}, {phi}}};
  const auto zeros = integral_decimals(find_filter("haar"), none, 20);
  ASSERT_EQ(zeros.size(), 1U);
  EXPECT_EQ(zeros[0].indices, (std::vector<int>{0, 0}));
  EXPECT_EQ(zeros[0].number.exact, "0");
}

}  // namespace
}  // namespace wavecurve::certified
