#include "verification/prints/print_verdict.hpp"

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

TEST(PrintVerdict, EachHasItsOwnName) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(PrintVerdict::undecided); ++i) {
    EXPECT_TRUE(names.insert(to_string(static_cast<PrintVerdict>(i))).second) << i;
  }
  EXPECT_EQ(to_string(PrintVerdict::agrees_to_digits), "agrees-to-digits");
  EXPECT_THROW(to_string(static_cast<PrintVerdict>(99)), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::verification
