#include "wavecurve/integrals/product_integrals.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/integrals/product_integrals.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve {
namespace {

constexpr BasisFunction phi{}, slope{.derivative = 1}, psi{.wavelet = true};

/// Taps of 16 digits, a system whose condition is below 10^4 (the condition of the two-scale
/// systems grows like the number of unknowns), and sums of unit size.
constexpr double tolerance = 1e-12;

TEST(ProductIntegralsInDouble, AgreeWithTheEnclosures) {
  const std::vector<ProductIntegral> all{
      {{{slope, false}, {phi}}},
      {{{slope, false}, {phi}, {psi}}},
      {{{phi, false}, {phi}, {phi}, {slope}}},
      {{{slope}, {phi}}, 2, DyadicInterval{1, 7, 2}},
      {{{phi, false}, {psi, true, 2}}, 1},
  };
  for (const std::string name : {"db3", "db5", "bspline3.3", "cdf9.7"}) {
    for (const ProductIntegral& integral : all) {
      const auto fast = product_integrals(find_filter_bank(name), integral);
      const auto proved = certified::product_integrals(certified::find_filter(name), integral, 80);
      ASSERT_EQ(fast.sizes, proved.sizes);
      for (std::size_t i = 0; i < fast.values.size(); ++i) {
        EXPECT_NEAR(fast.values[i], proved.values[i].to_double(), tolerance)
            << name << " " << name_of(integral) << " " << i;
      }
    }
  }
}

TEST(ProductIntegralsInDouble, RefuseWhatDoesNotExist) {
  EXPECT_THROW(product_integrals(find_filter_bank("db2"), {{{slope, false}, {slope}, {phi}}}),
               std::domain_error);
  EXPECT_NO_THROW(product_integrals(find_filter_bank("db2"), {{{slope, false}, {phi}, {phi}}}));
  EXPECT_THROW(product_integrals(find_filter_bank("db2"), {{{slope}, {phi}}}),
               std::invalid_argument);
}

TEST(ProductIntegralsInDouble, NameWhatTheyAre) {
  EXPECT_EQ(name_of(ProductIntegral{{{slope, false}, {psi, true, 1}}, 2, DyadicInterval{0, 2, 2}}),
            "int x^2 phi'(x) psi(2x - l) dx over [0, 1/2]");
}

}  // namespace
}  // namespace wavecurve
