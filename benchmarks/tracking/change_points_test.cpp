#include "benchmarks/tracking/change_points.hpp"

#include <random>

#include <gtest/gtest.h>

namespace wavecurve::tracking {
namespace {

using Points = std::vector<std::size_t>;

std::vector<double> levels(const std::vector<std::pair<int, double>>& parts, double noise,
                           std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution any(0.0, 1.0);
  std::vector<double> values;
  for (const auto& [count, level] : parts) {
    for (int i = 0; i < count; ++i) values.push_back(level + noise * any(random));
  }
  return values;
}

TEST(ChangePoints, AreFoundWhereTheyAre) {
  EXPECT_EQ(change_points(levels({{20, 1}, {20, 2}, {15, 1.5}}, 0.02, 1), 1e-4), (Points{20, 40}));
  EXPECT_EQ(change_points({5, 5, 5, 6, 6, 6}, 1e-4), Points{3});
  // One value apart from the rest is a level of its own: a loss, repaired at once.
  EXPECT_EQ(change_points({5, 5, 5, 6, 5, 5, 5, 5}, 1e-4), (Points{3, 4}));
}

TEST(ChangePoints, NoneInNoise) {
  int with_any = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    with_any += change_points(levels({{50, 1}}, 0.1, seed), 1e-4).empty() ? 0 : 1;
  }
  // 3 ln 50 = 11.7 a change; the largest of 49 dependent squares of normal numbers exceeds that in
  // a few of 100 series, and the estimated noise adds to it.
  EXPECT_LE(with_any, 20);
}

TEST(ChangePoints, AreFoundAmongAFewValues) {
  EXPECT_EQ(change_points({}, 1), Points());
  EXPECT_EQ(change_points({1, 2}, 1), Points());
  EXPECT_EQ(change_points({1, 1, 1}, 1e-4), Points());
}

}  // namespace
}  // namespace wavecurve::tracking
