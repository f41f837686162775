#include "verification/suite/claim.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

TEST(Claim, IdsAreOrderedAsAReaderWould) {
  const std::vector<std::string> expected = {"table-1",      "table-2",     "figure-3",
                                             "figure-10",    "banana",      "off-diagonal-energy",
                                             "erratum-2-5",  "erratum-3-5", "erratum-3-15",
                                             "erratum-3-16", "erratum-x"};
  std::vector<std::string> ids(expected.rbegin(), expected.rend());
  std::ranges::sort(ids, precedes);
  EXPECT_EQ(ids, expected);
}

TEST(Claim, AnIdDoesNotPrecedeItself) {
  EXPECT_FALSE(precedes("table-1", "table-1"));
  EXPECT_TRUE(precedes("alpha", "alpha-x"));
  EXPECT_FALSE(precedes("alpha-x", "alpha"));
}

TEST(Claim, TheSuiteIsOrderedUniqueAndComplete) {
  ASSERT_FALSE(claims().empty());
  std::set<std::string> ids;
  for (const Claim& claim : claims()) {
    EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
    EXPECT_FALSE(claim.title.empty()) << claim.id;
    EXPECT_FALSE(claim.location.empty()) << claim.id;
    EXPECT_FALSE(claim.printed.empty()) << claim.id;
    EXPECT_TRUE(claim.evaluate) << claim.id;
  }
  EXPECT_TRUE(std::ranges::is_sorted(
      claims(), [](const Claim& a, const Claim& b) { return precedes(a.id, b.id); }));
}

TEST(ClaimVerdict, EachHasItsOwnName) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(ClaimVerdict::stand_in); ++i) {
    EXPECT_TRUE(names.insert(to_string(static_cast<ClaimVerdict>(i))).second) << i;
  }
  EXPECT_EQ(to_string(ClaimVerdict::does_not_hold), "does-not-hold");
  EXPECT_THROW(to_string(static_cast<ClaimVerdict>(99)), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::verification
