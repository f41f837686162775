#include "solver_study.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"

#include "named_shapes.hpp"

namespace wavecurve::verification {
namespace {

Study study_of(std::vector<std::string> solvers) {
  const LagrangeSystem system(find_filter_bank<double>("db4"), 64, 6, {});
  return {system, named_shape("ellipse", 64), std::move(solvers)};
}

std::vector<StudyPoint> points_of(std::vector<std::string> solvers) {
  return run_study(study_of(std::move(solvers)), [](std::size_t, std::size_t) {});
}

TEST(SolverStudy, SeparatesModelErrorFromIntegrationError) {
  const auto closed = points_of({"spectral", "decoupled", "block-decoupled"});
  ASSERT_EQ(closed.size(), 3u);
  for (const StudyPoint& point : closed) EXPECT_FALSE(point.tolerance.has_value());
  EXPECT_EQ(closed[0].errors->displacement_l2_max, 0);
  // Known from an independent computation: 1.3 to 1.9 for simple shapes.
  EXPECT_GT(closed[1].errors->displacement_l2_max, 1.3);
  EXPECT_LT(closed[1].errors->displacement_l2_max, 1.9);
  EXPECT_LT(closed[2].errors->displacement_l2_max, closed[1].errors->displacement_l2_max);

  const auto swept = points_of({"coupled"});
  ASSERT_GT(swept.size(), 3u);
  EXPECT_GT(swept.front().errors->energy_norm_max, swept.back().errors->energy_norm_max);
  for (const StudyPoint& point : swept) {
    EXPECT_TRUE(point.tolerance.has_value());
    EXPECT_LE(point.errors->displacement_l2_final, point.errors->displacement_l2_max);
    EXPECT_GT(point.cost.evaluations, 0);
    EXPECT_GT(point.seconds, 0);
  }
}

TEST(SolverStudy, KeepsFailedSolvesAsFailed) {
  const auto points = points_of({"massless", "spectral"});
  ASSERT_GT(points.size(), 1u);
  EXPECT_NE(points.front().failure.find("density is 1"), std::string::npos);
  EXPECT_FALSE(points.front().errors.has_value());
  EXPECT_EQ(points.back().failure, "");
}

TEST(SolverStudy, ReportsProgressAndRefusesUnknownSolversFirst) {
  std::size_t last = 0, all = 0;
  const auto points =
      run_study(study_of({"spectral", "implicit-ldlt"}), [&](std::size_t done, std::size_t count) {
        EXPECT_EQ(done, last + 1);
        last = done;
        all = count;
      });
  EXPECT_EQ(last, points.size());
  EXPECT_EQ(all, points.size());
  EXPECT_THROW(run_study(study_of({"spectral", "magic"}),
                         [](std::size_t, std::size_t) { FAIL() << "nothing to be computed"; }),
               std::invalid_argument);
}

TEST(SolverStudy, RefusesAShapeAtRest) {
  Study study = study_of({"spectral"});
  study.shape = fitted_to_circle(3 * unit_circle(64));
  EXPECT_THROW(run_study(study, [](std::size_t, std::size_t) {}), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::verification
