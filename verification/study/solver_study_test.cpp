#include "verification/study/solver_study.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::verification {
namespace {

StudyPlan plan_of(std::vector<std::string> solvers, std::vector<StudySetting> settings = {{}}) {
  return {std::move(settings), std::move(solvers)};
}

std::vector<StudyPoint> points_of(std::vector<std::string> solvers) {
  return run_study(plan_of(std::move(solvers)));
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
  ASSERT_EQ(closed[1].model_errors.size(), 41u);
  EXPECT_EQ(closed[1].model_errors.back(), closed[1].errors->displacement_l2_final);

  const auto swept = points_of({"coupled"});
  ASSERT_GT(swept.size(), 3u);
  EXPECT_GT(swept.front().errors->energy_norm_max, swept.back().errors->energy_norm_max);
  for (const StudyPoint& point : swept) {
    EXPECT_TRUE(point.tolerance.has_value());
    EXPECT_TRUE(point.model_errors.empty());
    const StudyErrors& e = *point.errors;
    for (const auto& [final, max] : {std::pair(e.displacement_l2_final, e.displacement_l2_max),
                                     {e.maximum_norm_final, e.maximum_norm_max},
                                     {e.velocity_l2_final, e.velocity_l2_max},
                                     {e.energy_norm_final, e.energy_norm_max}}) {
      EXPECT_GT(final, 0);
      EXPECT_LE(final, max);
    }
    EXPECT_LT(e.energy_drift, 0.05);
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

TEST(SolverStudy, IsTheProductInOrderOnAllCores) {
  StudySetting damped;
  damped.stiffness_damping = 1;
  const StudyPlan plan = plan_of({"block-decoupled", "implicit-ldlt"}, {{}, damped});
  const auto points = run_study(plan), again = run_study(plan);
  ASSERT_EQ(points.size(), 14u);
  ASSERT_EQ(again.size(), 14u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(*points[i].setting, plan.settings[i / 7]);
    EXPECT_EQ(points[i].solver, plan.solvers[i % 7 > 0]);
    EXPECT_EQ(points[i].errors->energy_norm_max, again[i].errors->energy_norm_max);
    EXPECT_EQ(points[i].cost.operations, again[i].cost.operations);
  }
  EXPECT_NE(points[0].fingerprint, points[7].fingerprint);
}

TEST(SolverStudy, ReportsProgressAndRefusesUnknownSolversFirst) {
  std::size_t last = 0, all = 0;
  StudyHooks hooks;
  hooks.progress = [&](std::size_t done, std::size_t count) {
    EXPECT_EQ(done, last + 1);
    last = done;
    all = count;
  };
  const auto points = run_study(plan_of({"spectral", "implicit-ldlt"}), hooks);
  EXPECT_EQ(last, points.size());
  EXPECT_EQ(all, points.size());
  hooks.progress = [](std::size_t, std::size_t) { FAIL() << "nothing to be computed"; };
  EXPECT_THROW(run_study(plan_of({"spectral", "magic"}), hooks), std::invalid_argument);
}

TEST(SolverStudy, TakesUpKnownPoints) {
  const StudyPlan plan = plan_of({"decoupled", "implicit-ldlt"});
  StudyHooks hooks;
  std::vector<StudyPoint> known = run_study(plan);
  for (StudyPoint& point : known) point.seconds = 1e6;  // known by its colour
  known.erase(known.begin() + 2);
  ++known[3].fingerprint;  // another file of that name
  hooks.known = [&](const auto& take) {
    for (const StudyPoint& point : known) take(point);
  };
  std::vector<StudyPoint> computed;
  hooks.finished = [&](const StudyPoint& point) { computed.push_back(point); };
  const auto points = run_study(plan, hooks);
  ASSERT_EQ(points.size(), 7u);
  EXPECT_EQ(computed.size(), 2u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].seconds == 1e6, i != 2 && i != 4) << i;
  }
}

TEST(SolverStudy, EndsWithWhatAHookThrows) {
  StudyHooks hooks;
  int calls = 0;
  hooks.finished = [&](const StudyPoint&) {
    ++calls;
    throw std::runtime_error("disk full");
  };
  EXPECT_THROW(run_study(plan_of({"decoupled", "implicit-ldlt"}), hooks), std::runtime_error);
  EXPECT_EQ(calls, 1);
}

TEST(SolverStudy, ShardsAreDisjointAndTogetherTheWhole) {
  StudySetting other;
  other.shape = "star";
  const StudyPlan plan = plan_of({"block-decoupled", "implicit-ldlt"}, {{}, other});
  const auto whole = run_study(plan);
  for (const std::size_t count : {2u, 3u, 14u, 20u}) {
    std::size_t all = 0;
    for (std::size_t index = 1; index <= count; ++index) {
      const auto part = run_study(plan, {}, {index, count});
      for (std::size_t i = 0; i < part.size(); ++i) {
        const StudyPoint& same = whole.at(i * count + index - 1);
        EXPECT_EQ(*part[i].setting, *same.setting);
        EXPECT_EQ(part[i].solver, same.solver);
        EXPECT_EQ(part[i].errors, same.errors);
        EXPECT_EQ(part[i].cost, same.cost);
        EXPECT_EQ(part[i].fingerprint, same.fingerprint);
      }
      all += part.size();
    }
    EXPECT_EQ(all, whole.size()) << count;
  }
  EXPECT_THROW(run_study(plan, {}, {0, 2}), std::invalid_argument);
  EXPECT_THROW(run_study(plan, {}, {3, 2}), std::invalid_argument);
}

TEST(SolverStudy, RefusesAFileThatChangesDuringTheRun) {
  const auto file = std::filesystem::temp_directory_path() / "wavecurve_changing_study_test.csv";
  const auto write = [&](const char* last) {
    io::write_file(file, std::string("x,y\n0,0\n3,0\n3,2\n") + last);
  };
  write("0,1\n");
  StudySetting setting;
  setting.samples = 16;
  setting.levels = 4;
  setting.shape = file.string();
  StudyHooks hooks;
  hooks.known = [&](const auto&) { write("0,2\n"); };
  EXPECT_THROW(run_study(plan_of({"spectral"}, {setting}), hooks), std::runtime_error);
  std::filesystem::remove(file);
}

TEST(SolverStudy, RefusesAShapeAtRest) {
  const auto file = std::filesystem::temp_directory_path() / "wavecurve_solver_study_test.svg";
  io::write_file(file,
                 R"(<svg xmlns="http://www.w3.org/2000/svg"><circle cx="5" cy="5" r="4"/></svg>)");
  StudySetting setting;
  setting.samples = 4;  // the corners of a square: exactly the circle's points
  setting.levels = 2;
  setting.shape = file.string();
  EXPECT_THROW(run_study(plan_of({"spectral"}, {setting})), std::invalid_argument);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace wavecurve::verification
