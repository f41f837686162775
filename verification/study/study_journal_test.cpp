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

/// As it stands in the file.
std::string line_of(const StudyPoint& point) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("wavecurve_study_line_" + std::to_string(::getpid()));
  StudyJournal(path).append(point);
  const std::string line = io::read_file(path);
  std::filesystem::remove(path);
  return line;
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
  const std::string whole = io::read_file(path_), third = line_of(points[2]);
  for (const std::size_t torn :
       {std::size_t{0}, std::size_t{1}, third.size() / 2, third.size() - 1}) {
    io::write_file(path_, whole + third.substr(0, torn));
    {
      StudyJournal journal(path_);
      EXPECT_EQ(journal.points().size(), 2u) << torn;
      EXPECT_EQ(journal.warnings().size(), torn == 0 ? 0u : 1u) << torn;
      EXPECT_EQ(io::read_file(path_), whole) << torn;
      journal.append(points[2]);
    }
    EXPECT_EQ(StudyJournal(path_).points().size(), 3u) << torn;
  }
}

TEST_F(StudyJournalTest, AFirstLineThatIsTornIsCutOffToo) {
  const std::string line = line_of(sample_points()[0]);
  for (const std::size_t torn : {std::size_t{1}, std::size_t{9}, line.size() - 1}) {
    io::write_file(path_, line.substr(0, torn));
    EXPECT_TRUE(StudyJournal(path_).points().empty());
    EXPECT_EQ(io::read_file(path_), "") << torn;
  }
}

TEST_F(StudyJournalTest, EveryAlteredCharacterIsFound) {
  const auto points = sample_points();
  const std::string first = line_of(points[0]), second = line_of(points[1]);
  // Here and there in the point, and each character of the checksum.
  for (std::size_t i = 0; i + 1 < first.size(); i += i + 30 < first.size() ? 11 : 1) {
    std::string altered = first;
    altered[i] = altered[i] == '1' ? '7' : '1';
    io::write_file(path_, altered + second);
    const StudyJournal journal(path_);
    ASSERT_EQ(journal.points().size(), 1u) << altered;
    EXPECT_EQ(journal.points()[0].solver, points[1].solver);
    ASSERT_EQ(journal.warnings().size(), 1u) << altered;
    EXPECT_NE(journal.warnings()[0].find(": line 1 "), std::string::npos);
  }
}

TEST_F(StudyJournalTest, DoesNotBelieveLinesWithoutAChecksum) {
  const auto points = sample_points();
  std::string text;
  for (int i = 0; i < 7; ++i) text += to_json_line(points[0]) + "\n";
  io::write_file(path_, text + line_of(points[1]));
  const StudyJournal journal(path_);
  EXPECT_EQ(journal.points().size(), 1u);
  EXPECT_EQ(journal.warnings(),
            (std::vector<std::string>{path_.string() +
                                      ": lines 1, 2, 3, 4, 5 and 2 more without a checksum, of a "
                                      "version before; measured anew"}));
  EXPECT_EQ(io::read_file(path_), text + line_of(points[1]));
}

TEST_F(StudyJournalTest, LeavesAloneWhatIsNoJournal) {
  for (const std::string text : {"a letter", "a letter\nof two lines\n", "{\"name\": 1}\n", "\n"}) {
    io::write_file(path_, text);
    EXPECT_THROW(StudyJournal journal(path_), std::invalid_argument) << text;
    EXPECT_EQ(io::read_file(path_), text);
  }
  EXPECT_THROW(StudyJournal("/dev/null"), std::invalid_argument);
}

TEST_F(StudyJournalTest, IsForOneRun) {
  const StudyJournal first(path_);
  EXPECT_THROW(StudyJournal second(path_), std::system_error);
}

TEST_F(StudyJournalTest, NamesAPathThatCannotBeWritten) {
  EXPECT_THROW(StudyJournal("/nowhere/points"), std::system_error);
  EXPECT_THROW(StudyJournal(std::filesystem::temp_directory_path()), std::system_error);
}

}  // namespace
}  // namespace wavecurve::verification
