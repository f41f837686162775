#include "wavecurve/certified/three_term_integrals.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/two_term_integrals.hpp"

namespace wavecurve::certified {
namespace {

constexpr long bits = 100;
constexpr BasisFunction phi{}, slope{.derivative = 1};

TEST(ThreeTermIntegrals, CollapseToTwoTermsByThePartitionOfUnity) {
  for (const std::string name : {"db3", "coif1", "bspline3.3"}) {
    const FilterDefinition definition = find_filter(name);
    const auto three = three_term_integrals(definition, slope, phi, phi, bits);
    const auto two = two_term_integrals(definition, slope, phi, bits);
    for (int l = three.first; l <= three.last; ++l) {
      Ball sum(0);
      for (int m = three.first; m <= three.last; ++m) sum += three.at(l, m);
      EXPECT_TRUE(sum.overlaps(two[l])) << name << " " << l;
      EXPECT_LT(sum.radius_double(), 1e-25);
    }
  }
}

TEST(ThreeTermIntegrals, IntegrateByPartsAndAreSymmetric) {
  const FilterDefinition db3 = find_filter("db3");
  const auto first = three_term_integrals(db3, slope, phi, phi, bits);
  const auto second = three_term_integrals(db3, phi, slope, phi, bits);
  const auto third = three_term_integrals(db3, phi, phi, slope, bits);
  for (int l = -4; l <= 4; ++l) {
    for (int m = -4; m <= 4; ++m) {
      EXPECT_TRUE((first.at(l, m) + second.at(l, m) + third.at(l, m)).contains_zero());
      EXPECT_TRUE(first.at(l, m).overlaps(first.at(m, l)));
      EXPECT_TRUE(second.at(l, m).overlaps(third.at(m, l)));
      EXPECT_TRUE(first.at(l, m).overlaps(second.at(-l, m - l)));  // x -> x + l
    }
  }
}

TEST(ThreeTermIntegrals, OfTheHatAreThoseOfItsPolynomials) {
  const auto mass = three_term_integrals(find_filter("bspline2.2"), phi, phi, phi, bits);
  EXPECT_TRUE(mass.at(0, 0).contains(Rational(1, 2)));   // 2 int_0^1 x^3
  EXPECT_TRUE(mass.at(1, 0).contains(Rational(1, 12)));  // int x^2 (1 - x)
  EXPECT_TRUE(mass.at(1, 1).contains(Rational(1, 12)));
  EXPECT_TRUE(mass.at(1, -1).contains(Rational(0)));
}

TEST(ThreeTermIntegrals, RefuseWhatIsNotKnownToExist) {
  EXPECT_THROW(three_term_integrals(find_filter("db2"), slope, slope, phi, bits),
               std::domain_error);
  EXPECT_THROW(three_term_integrals(find_filter("db3"), {.wavelet = true}, phi, phi, bits),
               std::invalid_argument);
  EXPECT_THROW(three_term_integrals(find_filter("db20"), slope, phi, phi, bits),
               std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::certified
