// A million points, with a stand-in for the solvers: what a study costs beside the solving.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "verification/study/solver_study.hpp"
#include "verification/study/study_journal.hpp"
#include "verification/study/study_json.hpp"
#include "verification/study/study_summary.hpp"

namespace wavecurve::verification {
namespace {

namespace fs = std::filesystem;

/// Settings that differ in their dampings; with these solvers each has 37 points.
StudyPlan plan_of(std::size_t settings) {
  StudyPlan plan{
      {}, {"decoupled", "coupled", "implicit-ldlt", "implicit", "block-decoupled", "massless"}};
  for (std::size_t i = 0; i < settings; ++i) {
    StudySetting setting;
    setting.samples = 16;
    setting.levels = 4;
    setting.mass_damping = static_cast<double>(i);
    plan.settings.push_back(setting);
  }
  return plan;
}

void stand_in(StudyPoint& point) {
  const double error = 1e-3 * (1 + point.setting->mass_damping) * point.tolerance.value_or(1);
  point.errors = {error, error / 3, error / 7, error / 11, error / 13, error, error / 17, error, 0};
  if (!point.tolerance) point.model_errors.assign(41, error);
  point.cost = {1000, 123456};
  point.seconds = 1.25e-3;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double mebibytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// A folder for the files of a study, which it takes with it.
class StudyScale : public testing::Test {
 protected:
  void SetUp() override { fs::create_directory(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  /// All that `wavecurve compare -o` does but for the page; the number of points.
  std::size_t study(const StudyPlan& plan, const std::function<void(StudyPoint&)>& solve) const {
    StudyJournal journal(folder_ / "points");
    StudyHooks hooks;
    hooks.known = [&](const auto& take) { journal.read(take); };
    hooks.finished = [&](const StudyPoint& point) { journal.append(point); };
    hooks.stand_in = solve;
    const auto points = run_study(plan, hooks);
    const StudySummary summary = summarize(points);
    io::write_file(folder_ / "json", [&](const auto& sink) { write_json(points, summary, sink); });
    io::write_file(folder_ / "csv", [&](const auto& sink) { write_csv(points, sink); });
    return points.size();
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("wavecurve_study_scale_" + std::to_string(::getpid()));
};

TEST_F(StudyScale, AMillionPointsNeedLittleBesideTheSolving) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
  GTEST_SKIP() << "instrumented, it takes longer and more";
#endif
  constexpr double most_microseconds = 20;
  const std::size_t of_a_setting = points_of(plan_of(1)).size();
  // What else the machine does only adds: the minimum of up to three studies counts.
  double microseconds = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < 3 && microseconds > most_microseconds; ++attempt) {
    fs::remove(folder_ / "points");
    const double start = processor_seconds();
    const std::size_t count = study(plan_of(1000000 / of_a_setting), stand_in);
    microseconds =
        std::min(microseconds, 1e6 * (processor_seconds() - start) / static_cast<double>(count));
    std::printf("%zu points: %.1f microseconds each, %.0f MiB\n", count, microseconds, mebibytes());
  }
  EXPECT_LE(mebibytes(), 300);
  EXPECT_LE(microseconds, most_microseconds);
}

TEST_F(StudyScale, TenThousandPointsAreTakenUpAgain) {
  const StudyPlan plan = plan_of(300);
  const std::size_t count = study(plan, stand_in);
  EXPECT_EQ(count, points_of(plan).size());
  const std::string json = io::read_file(folder_ / "json"), csv = io::read_file(folder_ / "csv");
  EXPECT_EQ(study(plan, [](StudyPoint&) { FAIL() << "all are known"; }), count);
  EXPECT_EQ(io::read_file(folder_ / "json"), json);
  EXPECT_EQ(io::read_file(folder_ / "csv"), csv);
}

}  // namespace
}  // namespace wavecurve::verification
