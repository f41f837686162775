#include "verification/study/study_summary.hpp"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

StudyPoint point_of(const std::string& solver, double tolerance, long long evaluations,
                    double error) {
  StudyPoint point;
  point.solver = solver;
  if (tolerance > 0) point.tolerance = tolerance;
  point.errors = StudyErrors{};
  point.errors->displacement_l2_max = error;
  point.cost = {evaluations, 10 * evaluations};
  point.seconds = 1e-6 * static_cast<double>(evaluations);
  return point;
}

TEST(StudySummary, NamesTheFloorsOfTheModelsOnly) {
  StudyPoint failed = point_of("block-decoupled", 0, 0, 0);
  failed.errors.reset();
  failed.failure = "no memory";
  const StudySummary summary =
      summarize({point_of("spectral", 0, 0, 0), point_of("decoupled", 0, 0, 1.69), failed,
                 point_of("coupled", 1e-2, 10, 1e-3)});
  ASSERT_EQ(summary.floors.size(), 1u);
  EXPECT_EQ(summary.floors[0].solver, "decoupled");
  EXPECT_EQ(summary.floors[0].displacement_l2_max, 1.69);
  EXPECT_TRUE(summary.orders.empty());
}

TEST(StudySummary, FitsTheOrderInTheAsymptoticRange) {
  // Stability sets the first steps, then order 3, then rounding.
  std::vector<StudyPoint> points = {point_of("coupled", 1e-2, 100, 0.3),
                                    point_of("coupled", 1e-3, 101, 0.1)};
  for (int i = 0; i < 4; ++i) {
    points.push_back(point_of("coupled", std::pow(10, -4 - i), 120 << i, 0.01 * std::pow(8, -i)));
  }
  points.push_back(point_of("coupled", 1e-8, 120 << 4, 1e-13));
  const StudySummary summary = summarize(points);
  ASSERT_EQ(summary.orders.size(), 1u);
  const ObservedOrder& order = summary.orders[0];
  EXPECT_EQ(order.fit.points, 4u);
  EXPECT_EQ(order.tolerances.front(), 1e-4);
  EXPECT_NEAR(order.fit.exponent, 3, 1e-12);
}

TEST(StudySummary, HasNoOrderWhereTheToleranceDoesNotSetTheSteps) {
  std::vector<StudyPoint> points;
  for (int i = 0; i < 6; ++i) {
    points.push_back(point_of("coupled", std::pow(10, -2 - i), 1000 + i, std::pow(0.1, i)));
  }
  EXPECT_TRUE(summarize(points).orders.empty());
}

TEST(StudySummary, FitsTheGrowthAtTheOuterTolerancesSolvedAtAllSizes) {
  std::vector<StudyPoint> points;
  for (const Eigen::Index samples : {16, 32, 64}) {
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4}) {
      const long long cost = tolerance == 1e-1 ? samples : samples * samples;
      StudyPoint point = point_of("coupled", tolerance, cost, 1e-3);
      StudySetting setting;
      setting.samples = samples;
      setting.levels = static_cast<int>(std::log2(samples));
      point.setting = std::make_shared<const StudySetting>(setting);
      if (tolerance == 1e-4 && samples == 64) point.errors.reset();
      points.push_back(point);
    }
  }
  const StudySummary summary = summarize(points);
  ASSERT_EQ(summary.growth.size(), 2u);
  EXPECT_EQ(summary.growth[0].tolerance, 1e-1);
  EXPECT_NEAR(summary.growth[0].operations.exponent, 1, 1e-12);
  const Growth& growth = summary.growth[1];
  EXPECT_EQ(growth.tolerance, 1e-3);
  EXPECT_EQ(growth.samples, (std::vector<Eigen::Index>{16, 32, 64}));
  EXPECT_NEAR(growth.operations.exponent, 2, 1e-12);
  EXPECT_NEAR(growth.seconds.exponent, 2, 1e-12);
  EXPECT_EQ(settings_of(points).size(), 3u);
}

}  // namespace
}  // namespace wavecurve::verification
