#include "wavecurve/io/files/detail/natural_order.hpp"

#include <string_view>

#include <gtest/gtest.h>

namespace wavecurve::io {
namespace {

TEST(NaturalOrder, NumbersCountByTheirValue) {
  constexpr std::string_view sorted[] = {"",         "12",        "a",        "a-x",
                                         "figure-2", "figure-2a", "figure-9", "figure-010",
                                         "figure-x", "g1.5",      "g1.12"};
  for (const std::string_view& a : sorted) {
    for (const std::string_view& b : sorted) {
      EXPECT_EQ(naturally_precedes(a, b), &a < &b) << a << " and " << b;
    }
  }
  EXPECT_FALSE(naturally_precedes("a01", "a1") || naturally_precedes("a1", "a01"));
}

}  // namespace
}  // namespace wavecurve::io
