#include "verification/quantities/entry_index.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

TEST(EntryIndex, IsAnIntegerAPointOrSeveral) {
  EXPECT_EQ(parse_entry_index("-3"), EntryIndex(-3));
  EXPECT_EQ(parse_entry_index("+4"), EntryIndex(4));
  EXPECT_EQ(parse_entry_index("1/2"), EntryIndex::at(0.5));
  EXPECT_EQ(parse_entry_index("-3/8").text(), "-3/8");
  EXPECT_EQ(parse_entry_index("0.375"), EntryIndex::at(0.375));
  EXPECT_EQ(parse_entry_index("2.0"), EntryIndex(2));
  EXPECT_EQ(parse_entry_index("(2, -1)"), EntryIndex::pair(2, -1));
  EXPECT_EQ(parse_entry_index("2 -1").text(), "(2, -1)");
  EXPECT_EQ(parse_entry_index("-0"), EntryIndex(0));
  EXPECT_EQ(parse_entry_index("(1/2, -1)").text(), "(1/2, -1)");
  EXPECT_EQ(parse_entry_index("1;0;-2").integers(), (std::vector<int>{1, 0, -2}));
  EXPECT_THROW(parse_entry_index("(1/2, -1)").integers(), std::domain_error);
}

TEST(EntryIndex, LevelOfADyadicPointIsTheLeastThatMakesItWhole) {
  EXPECT_EQ(EntryIndex(0).dyadic_level(), 0);
  for (const double odd : {1.0, -3.0, 12345.0}) {
    for (int level = 0; level <= 30; ++level) {
      EXPECT_EQ(EntryIndex::at(std::ldexp(odd, -level)).dyadic_level(), level) << odd;
    }
    EXPECT_EQ(EntryIndex::at(std::ldexp(odd, 3)).dyadic_level(), 0) << odd;
  }
}

TEST(EntryIndex, RefusesWhatIsNone) {
  for (const char* text :
       {"", "x", "0.1", "1/3", "1/0", "1/", "99999999999999999999", "-2147483648", "1e300",
        "(1,2,3,4)", "(1, x)", "(1/3, 2)", "(1, 1/2)", "nan", "1e-30"}) {
    EXPECT_THROW(parse_entry_index(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace wavecurve::verification
