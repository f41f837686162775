#include "verification/study/study_journal.hpp"

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "verification/study/study_json.hpp"

namespace wavecurve::verification {
namespace {

class StudyJournalTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }

  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() /
      ("wavecurve_study_journal_test_" + std::to_string(::getpid()));
};

std::vector<StudyPoint> sample_points() {
  return run_study({{{}}, {"decoupled", "massless", "implicit-ldlt"}});
}

TEST(StudyJson, IsReadBackExactly) {
  for (StudyPoint point : sample_points()) {
    point.setting.shape = "a \"name\" \\ of\na file.svg";
    const std::string line = to_json_line(point);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const StudyPoint again = point_of_json_line(line);
    EXPECT_EQ(to_json_line(again), line);
    EXPECT_EQ(again.setting, point.setting);
    EXPECT_EQ(again.tolerance, point.tolerance);
    EXPECT_EQ(again.model_errors, point.model_errors);
    EXPECT_EQ(again.failure, point.failure);
    EXPECT_EQ(again.seconds, point.seconds);
    ASSERT_EQ(again.errors.has_value(), point.errors.has_value());
    if (!point.errors) continue;
    EXPECT_EQ(again.errors->maximum_norm_final, point.errors->maximum_norm_final);
    EXPECT_EQ(again.errors->energy_drift, point.errors->energy_drift);
  }
  EXPECT_THROW(point_of_json_line("{}"), std::invalid_argument);
  EXPECT_THROW(point_of_json_line("no JSON"), std::invalid_argument);
}

TEST_F(StudyJournalTest, KeepsWholeLinesAndCutsOffATornOne) {
  const auto points = sample_points();
  {
    StudyJournal journal(path_);
    EXPECT_TRUE(journal.points().empty());
    journal.append(points[0]);
    journal.append(points[1]);
  }
  const std::string whole = io::read_file(path_), third = to_json_line(points[2]) + "\n";
  for (const std::size_t torn :
       {std::size_t{0}, std::size_t{1}, third.size() / 2, third.size() - 1}) {
    io::write_file(path_, whole + third.substr(0, torn));
    StudyJournal journal(path_);
    EXPECT_EQ(journal.points().size(), 2u) << torn;
    EXPECT_EQ(io::read_file(path_), whole) << torn;
    journal.append(points[2]);
    EXPECT_EQ(StudyJournal(path_).points().size(), 3u) << torn;
  }
}

TEST_F(StudyJournalTest, PassesOverLinesOfOthers) {
  const auto points = sample_points();
  io::write_file(path_,
                 "{\"solver\": \"of a version to come\"}\n" + to_json_line(points[0]) + "\n\n");
  const StudyJournal journal(path_);
  ASSERT_EQ(journal.points().size(), 1u);
  EXPECT_EQ(journal.points()[0].solver, "decoupled");
}

TEST_F(StudyJournalTest, NamesAPathThatCannotBeWritten) {
  EXPECT_THROW(StudyJournal("/nowhere/points"), std::system_error);
  EXPECT_THROW(StudyJournal(std::filesystem::temp_directory_path()), std::system_error);
}

}  // namespace
}  // namespace wavecurve::verification
