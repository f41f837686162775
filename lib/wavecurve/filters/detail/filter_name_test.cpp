#include "wavecurve/filters/detail/filter_name.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve {
namespace {

TEST(FilterName, NumberAfterThePrefix) {
  EXPECT_EQ(number_after("db", "db12"), 12);
  EXPECT_EQ(number_after("", "7"), 7);
  for (const char* other : {"db", "db0", "db04", "db-4", "db+4", "db4 ", "db4x", "sym4", "",
                            "db99999999999999999999"}) {
    EXPECT_EQ(number_after("db", other), std::nullopt) << other;
  }
}

TEST(FilterName, OrderBeyondItsBoundsIsRefusedByName) {
  EXPECT_NO_THROW(require_order("db1", 1, 1, 38));
  EXPECT_NO_THROW(require_order("db38", 38, 1, 38));
  EXPECT_THROW(require_order("db0", 0, 1, 38), std::invalid_argument);
  try {
    require_order("db39", 39, 1, 38);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "the order of filter db39 is 39, but must be from 1 to 38");
  }
}

TEST(FilterName, AForeignFilterIsRefusedWithAReason) {
  const auto message = [](const char* name) {
    try {
      refuse_filter_name(name, {"db1-db38"});
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(message("mb4.2"),
            "filter 'mb4.2' is a minimum-bandwidth filter, whose taps have no "
            "closed definition here; give them as a JSON file");
  EXPECT_EQ(message("qshift_a").find("filter 'qshift_a' is a q-shift filter"), 0U);
  EXPECT_EQ(message("mexh"),
            "filter 'mexh' is a continuous wavelet, which has no filter of finitely many taps");
  for (const char* other : {"", "mbx", "fkorovkin", "9"}) {
    EXPECT_EQ(message(other), "unknown filter '" + std::string(other) + "'; known: db1-db38");
  }
}

TEST(FilterName, OrdersOfASpline) {
  const auto orders = spline_orders("bspline3.5");
  ASSERT_TRUE(orders);
  EXPECT_EQ(orders->order, 3);
  EXPECT_EQ(orders->dual_order, 5);
  EXPECT_TRUE(spline_orders("bspline100.100"));
  for (const char* other : {"bspline", "bspline3", "bspline3.", "bspline.3", "bspline0.2",
                            "bspline3.05", "spline3.3", "cdf9.7"}) {
    EXPECT_FALSE(spline_orders(other)) << other;
  }
  for (const char* bad : {"bspline101.1", "bspline1.101", "bspline3.4"}) {
    EXPECT_THROW(spline_orders(bad), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace wavecurve
