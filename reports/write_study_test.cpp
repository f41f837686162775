#include "reports/write_study.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/read_file.hpp"

#include "reports/study_charts.hpp"
#include "reports/study_overview.hpp"

namespace wavecurve::reports {
namespace {

using namespace verification;

StudyPoint point_of(const std::string& solver, std::optional<double> tolerance, double error) {
  StudyPoint point;
  point.solver = solver;
  point.tolerance = tolerance;
  point.errors = StudyErrors{};
  point.errors->displacement_l2_max = error;
  if (!tolerance) point.model_errors.assign(41, error);
  point.cost = {10, 1000};
  point.seconds = 1e-3;
  return point;
}

StudyPoint failed(const std::string& solver, double tolerance) {
  StudyPoint point = point_of(solver, tolerance, 0);
  point.errors.reset();
  point.failure = "the step size <vanishes>";
  return point;
}

std::vector<StudyPoint> some_points() {
  std::vector<StudyPoint> points = {point_of("spectral", {}, 0), point_of("decoupled", {}, 1.69),
                                    point_of("coupled", 1e-2, 1e-3),
                                    point_of("coupled", 1e-4, 1e-5), failed("coupled", 1e-6)};
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(points[i]);
    StudySetting setting;
    setting.shape = "my \"drawing\".svg";
    points.back().setting = std::make_shared<const StudySetting>(setting);
    if (points.back().solver == "decoupled") points.back().errors->displacement_l2_max = 0.01;
  }
  return points;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(WriteStudy, AnswersInASentence) {
  const auto points = some_points();
  const auto text = answer(points, summarize(points));
  ASSERT_EQ(text.size(), 2u);
  EXPECT_EQ(
      text[0],
      "decoupled: floor 0.01 to 1.7, its model error relative to the initial displacement; at most 5 "
      "% in 1 of 2 settings: my \"drawing\".svg.");
  EXPECT_EQ(text[1], "Solvers with steps have no such floor: coupled reaches 1e-05.");
  EXPECT_TRUE(answer({points[0]}, summarize({points[0]})).empty());
}

TEST(WriteStudy, DrawsEverySettingAndShowsFailures) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("wavecurve_write_study_test_" + std::to_string(::getpid()));
  const auto points = some_points();
  write_study(points, summarize(points), folder);
  const std::string page = io::read_file(folder / "index.html");
  std::filesystem::remove_all(folder);
  for (const char* figure :
       {"floors", "work-precision-1", "model-error-1", "work-precision-2", "model-error-2"}) {
    EXPECT_EQ(count_of(page, "id=\"figure-" + std::string(figure) + "\""), 1u) << figure;
  }
  EXPECT_EQ(count_of(page, "failed: the step size &lt;vanishes&gt;"), 2u);
  EXPECT_GT(count_of(page, "decoupled: floor 1.7, its model error"), 0u);
}

TEST(WriteStudy, WhereNothingSolvedOrNothingErredThereIsAPageAllTheSame) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("wavecurve_write_study_none_" + std::to_string(::getpid()));
  const auto page_of = [&](const std::vector<StudyPoint>& points) {
    write_study(points, summarize(points), folder);
    std::string page = io::read_file(folder / "index.html");
    std::filesystem::remove_all(folder);
    return page;
  };
  const std::string none = page_of({failed("coupled", 1e-2), failed("coupled", 1e-4)});
  EXPECT_EQ(count_of(none, "Every solve of this setting failed"), 1u);
  EXPECT_EQ(count_of(none, "failed: the step size &lt;vanishes&gt;"), 2u);
  const std::string exact = page_of({point_of("spectral", {}, 0)});
  EXPECT_EQ(count_of(exact, "Every solve"), 0u);
  EXPECT_EQ(count_of(exact, "<figure"), 0u);
}

/// A setting for each damping; the model's error grows with it, as no real one does.
std::vector<StudyPoint> points_of_many_settings(int count) {
  std::vector<StudyPoint> points;
  for (int i = 0; i < count; ++i) {
    StudySetting setting;
    setting.stiffness_damping = i;
    setting.shape = i % 2 == 0 ? "star" : "dent";
    const auto shared = std::make_shared<const StudySetting>(setting);
    points.push_back(point_of("decoupled", {}, 0.01 * (i + 1)));
    for (const double tolerance : {1e-2, 1e-4}) {
      points.push_back(i == 5 ? failed("coupled", tolerance)
                              : point_of("coupled", tolerance, tolerance * (i + 1)));
    }
    for (std::size_t k = points.size() - 3; k < points.size(); ++k) points[k].setting = shared;
  }
  return points;
}

TEST(WriteStudy, OfManySettingsThePageHasTheBestTheWorstAndAMap) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("wavecurve_write_study_many_" + std::to_string(::getpid()));
  const auto points = points_of_many_settings(100);
  const StudySummary summary = summarize(points);
  write_study(points, summary, folder);
  const std::string page = io::read_file(folder / "index.html");
  std::filesystem::remove_all(folder);
  EXPECT_EQ(count_of(page, "<figure"), 1u);
  EXPECT_EQ(count_of(page, "id=\"figure-accuracy-map\""), 1u);
  EXPECT_LT(page.size(), 100000u);
  const Table map = accuracy_map(points).data;
  ASSERT_EQ(map.rows.size(), 2u);
  EXPECT_EQ(map.rows[1],
            (std::vector<std::string>{"coupled", "2", "0.0001", "99", "1", "0.0001", "0.0051",
                                      "0.01", "db4, 64 samples, 6 levels; dent, damping 0, 99"}));
  const Table extremes = extremes_table(points, summary);
  ASSERT_EQ(extremes.rows.size(), 20u);
  EXPECT_EQ(extremes.rows.front(),
            (std::vector<std::string>{"decoupled", "worst", "1", "dent, s_2 = 99"}));
  EXPECT_EQ(extremes.rows.back(),
            (std::vector<std::string>{"decoupled", "best", "0.01", "star, s_2 = 0"}));
  const Table influence = influence_table(summary);
  ASSERT_EQ(influence.rows.size(), 102u);  // of the dampings, then of the shapes
  EXPECT_EQ(influence.rows.back()[1], "dent");
  EXPECT_EQ(influence.rows.back()[6], "1");
  EXPECT_EQ(accuracy_map(some_points()).data.rows.size(), 3u);
}

TEST(WriteStudy, ChartsHaveOneRowAPoint) {
  const auto points = some_points();
  const Chart chart = work_precision_chart(points, *points[0].setting, 1);
  EXPECT_EQ(chart.data.rows.size(), 5u);
  for (const auto& row : chart.data.rows) EXPECT_EQ(row.size(), chart.data.columns.size());
  const Chart floors = floors_chart(points);
  ASSERT_EQ(floors.data.rows.size(), 2u);
  for (const auto& row : floors.data.rows) EXPECT_EQ(row.size(), floors.data.columns.size());
  EXPECT_EQ(floors.data.rows[1][1], "0.01");
  EXPECT_EQ(floors.data.rows[1][3], "coupled");
  EXPECT_EQ(model_error_chart(points, *points[0].setting, 1).data.rows.size(), 41u);
  EXPECT_TRUE(model_error_chart({points[2]}, *points[2].setting, 1).data.rows.empty());
}

}  // namespace
}  // namespace wavecurve::reports
