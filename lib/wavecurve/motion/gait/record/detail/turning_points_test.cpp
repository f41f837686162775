#include "wavecurve/motion/gait/record/detail/turning_points.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace wavecurve::gait {
namespace {

// A cosine at uneven times turns at whole multiples of pi. A parabola through points within 0.1 of
// the range, that is cos x > 0.8 or |x| < 0.65, is the cosine but for x^4 / 24, which is even: only
// the uneven spacing moves its vertex, by a small share of a step.
TEST(TurningPoints, FindsThoseOfACosine) {
  Eigen::VectorXd times(215), values(215);
  for (int i = 0; i < 215; ++i) {
    times[i] = 0.1 * i + 0.02 * std::sin(i * i);
    values[i] = std::cos(times[i]);
  }
  const auto turns = turning_points(times, values);
  ASSERT_EQ(turns.size(), 6U);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    EXPECT_NEAR(turns[i].time, M_PI * static_cast<double>(i + 1), 0.01);
    EXPECT_NEAR(turns[i].value, i % 2 == 0 ? -1 : 1, 0.01);
    EXPECT_EQ(turns[i].is_maximum, i % 2 == 1);
  }
}

// Noise of 1 % of the range, and a parabola through n = 26 points at |x| < 0.65: the slope of its
// middle errs by noise / (sqrt(n) 0.65 / sqrt 3) = 0.01, and so does the vertex, as the curvature
// is 1.
TEST(TurningPoints, AreNotMovedFarByNoise) {
  std::mt19937 generator(3);
  std::normal_distribution<double> noise(0, 0.02);
  Eigen::VectorXd times(430), values(430);
  for (int i = 0; i < 430; ++i) {
    times[i] = 0.05 * i;
    values[i] = std::cos(times[i]) + noise(generator);
  }
  const auto turns = turning_points(times, values);
  ASSERT_EQ(turns.size(), 6U);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    EXPECT_NEAR(turns[i].time, M_PI * static_cast<double>(i + 1), 5 * 0.01);
  }
}

TEST(TurningPoints, SkipsDetoursAndEnds) {
  Eigen::VectorXd values(9);
  values << 9, 4, 0, 3, 2, 6, 10, 7, 5;  // 3, 2: a detour of a tenth of the range
  const auto turns = turning_points(Eigen::VectorXd::LinSpaced(9, 0, 8), values);
  ASSERT_EQ(turns.size(), 2U);
  EXPECT_FALSE(turns[0].is_maximum);
  EXPECT_NEAR(turns[0].time, 2, 0.5);
  EXPECT_TRUE(turns[1].is_maximum);
  EXPECT_NEAR(turns[1].time, 6, 0.5);
}

}  // namespace
}  // namespace wavecurve::gait
