#include "verification/quantities/list_quantity.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <stdexcept>
#include <string>

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

std::map<EntryIndex, std::string> exact_of(const std::vector<ListedEntry>& entries) {
  std::map<EntryIndex, std::string> exact;
  for (const auto& [index, number] : entries) exact[index] = number.exact.value_or("");
  return exact;
}

// Hats on [0, 1]: int x^2 = 1/3 and int x (1 - x) = 1/6, whichever hat it is.
TEST(ListQuantity, IntegralsOverAnInterval) {
  const auto exact = exact_of(listed("bspline2.2", "int(phi(l), phi(m)) on [0,1]"));
  EXPECT_EQ(exact, (std::map<EntryIndex, std::string>{{EntryIndex::pair(0, 0), "1/3"},
                                                      {EntryIndex::pair(0, 1), "1/6"},
                                                      {EntryIndex::pair(1, 0), "1/6"},
                                                      {EntryIndex::pair(1, 1), "1/3"}}));
}

// int_0^x (1 - t)^2 dt = 7/24 and 1/3 at 1/2 and 1.
TEST(ListQuantity, IntegralsUpToX) {
  FilterValues hat(find_table_filter("bspline2.2"));
  const Quantity up_to_x = parse_quantity("int(phi(l), phi) on [0,x]");
  const auto value = [&](double x, int l) {
    return hat.value(up_to_x, EntryIndex::tuple(x, std::span(&l, 1))).enclosure(128).to_double();
  };
  EXPECT_NEAR(value(0.5, 0), 7.0 / 24, 1e-15);
  EXPECT_NEAR(value(1, 0), 1.0 / 3, 1e-15);
  EXPECT_NEAR(value(2, 0), value(1, 0), 1e-15);
  EXPECT_NEAR(value(-1, 0), -1.0 / 3, 1e-15);
  // All of the line is both sides of 0.
  const auto listed_values =
      listed("db3", "int(phi'(l), phi) on [0,x]", {.digits = 12, .level = 1});
  const auto whole = listed("db3", "int(phi, phi')", {.digits = 12});
  for (const auto& [index, number] : listed_values) {
    if (index.first != 5) continue;
    const auto same = std::ranges::find(
        whole, index.second, [](const ListedEntry& entry) { return entry.index.integer(); });
    ASSERT_NE(same, whole.end());
    EXPECT_NEAR(std::stod(same->number.value), std::stod(number.value), 1e-11) << index.text();
  }
  EXPECT_TRUE(std::ranges::any_of(
      listed_values, [](const ListedEntry& entry) { return entry.index.text() == "(1/2, 0)"; }));
}

// Each factor's shifts add up to 1: summed over n, four factors are three.
TEST(ListQuantity, FourFactorsAddUpToThree) {
  std::map<EntryIndex, double> sums;
  for (const auto& [index, number] : listed("db2", "int(phi, phi, phi, phi)", {.digits = 14})) {
    sums[EntryIndex::pair(index.integers()[0], index.second)] += std::stod(number.value);
  }
  const auto three = listed("db2", "int(phi, phi, phi)", {.digits = 14});
  ASSERT_EQ(sums.size(), three.size());
  for (const auto& [index, number] : three) {
    EXPECT_NEAR(sums[index], std::stod(number.value), 1e-12) << index.text();
  }
}

TEST(ListQuantity, RefusesWhatIsNotThere) {
  EXPECT_THROW(listed("db2", "mu"), std::domain_error);
  EXPECT_THROW(listed("db5", "holder(phi)"), std::domain_error);
  EXPECT_THROW(listed("db4", "phi", {.level = 99}), std::invalid_argument);
  EXPECT_THROW(listed("db4", "h", {.digits = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::verification
