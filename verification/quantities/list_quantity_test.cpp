#include "verification/quantities/list_quantity.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

std::vector<ListedEntry> listed(const std::string& filter, const std::string& quantity,
                                const ListingRequest& request = {}) {
  FilterValues values(find_table_filter(filter));
  return list_quantity(values, parse_quantity(quantity), request);
}

TEST(ListQuantity, BeylkinsIntegralsOfD6AreExactFractions) {
  const auto r = listed("db3", "r", {.digits = 20});
  ASSERT_EQ(r.size(), 9u);
  EXPECT_EQ(r.front().index, EntryIndex(-4));
  EXPECT_EQ(r[0].number.exact, "1/2920");
  EXPECT_EQ(r[3].number.exact, "272/365");
  EXPECT_EQ(r[4].number.exact, "0");
  EXPECT_EQ(r[5].number.exact, "-272/365");
}

TEST(ListQuantity, BothSignConventionsOfTheSecondDerivativeAreThere) {
  const auto mu = listed("db4", "mu", {.digits = 15});
  const auto second = listed("db4", "int(phi, phi'')", {.digits = 15});
  ASSERT_EQ(mu.size(), second.size());
  for (std::size_t i = 0; i < mu.size(); ++i) {
    const std::string& value = mu[i].number.value;
    EXPECT_EQ(second[i].number.value, value.starts_with('-') ? value.substr(1) : "-" + value);
  }
}

TEST(ListQuantity, FunctionsMomentsAndPairsHaveTheirIndices) {
  EXPECT_EQ(listed("db2", "phi", {.digits = 10, .level = 1}).size(), 5u);
  EXPECT_EQ(listed("db2", "phi", {.digits = 10}).front().number.value, "1.366025404");
  const auto moments = listed("db3", "moment(psi)", {.digits = 8, .highest_moment = 4});
  ASSERT_EQ(moments.size(), 5u);
  EXPECT_EQ(moments[2].number.exact, "0");
  const auto pairs = listed("bspline2.2", "int(phi, phi, phi)", {.digits = 6});
  EXPECT_EQ(pairs.size(), 7u);
  EXPECT_EQ(listed("cdf9.7", "lifting", {.digits = 10}).front().number.value, "-1.586134342");
  EXPECT_EQ(listed("db2", "holder(phi)", {.digits = 10}).front().number.value, "0.5500156865");
}

TEST(ListQuantity, RefusesWhatIsNotThere) {
  EXPECT_THROW(listed("db2", "mu"), std::domain_error);
  EXPECT_THROW(listed("db5", "holder(phi)"), std::domain_error);
  EXPECT_THROW(listed("db4", "phi", {.level = 99}), std::invalid_argument);
  EXPECT_THROW(listed("db4", "h", {.digits = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::verification
