#include "verification/study/study_journal.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "verification/study/solver_study.hpp"
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

/// What it gives when it is read.
std::vector<StudyPoint> points_in(StudyJournal& journal) {
  std::vector<StudyPoint> points;
  journal.read([&](StudyPoint point) { points.push_back(std::move(point)); });
  return points;
}

std::vector<StudyPoint> points_in(const std::filesystem::path& path) {
  StudyJournal journal(path);
  return points_in(journal);
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

TEST(StudyJson, PlanIsReadBackExactly) {
  StudyPlan plan{{{}, {"coif2", 16, 3, "a \"file\".svg", 0.1, 1e-300}}, {"coupled", "decoupled"}};
  EXPECT_EQ(plan_of_json(to_json(plan)), plan);
  EXPECT_THROW(plan_of_json("{}"), std::invalid_argument);
  EXPECT_THROW(plan_of_json(R"({"settings": [{}], "solvers": []})"), std::invalid_argument);
}

TEST(StudyJson, IsOneDocumentThoughItIsWrittenInPieces) {
  const auto points = sample_points();
  std::string text;
  write_json(points, summarize(points), [&](std::string_view piece) { text += piece; });
  const auto document = nlohmann::ordered_json::parse(text);
  EXPECT_EQ(document.dump(2) + "\n", text);
  ASSERT_EQ(document["points"].size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(document["points"][i].dump(), to_json_line(points[i]));
  }
}

TEST(StudyJson, IsReadBackExactly) {
  for (StudyPoint point : sample_points()) {
    StudySetting setting = *point.setting;
    setting.shape = "a \"name\" \\ of\na file.svg";
    point.setting = std::make_shared<const StudySetting>(setting);
    const std::string line = to_json_line(point);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const StudyPoint again = point_of_json_line(line);
    EXPECT_EQ(to_json_line(again), line);
    EXPECT_EQ(*again.setting, *point.setting);
    EXPECT_EQ(again.fingerprint, point.fingerprint);
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
    EXPECT_TRUE(points_in(journal).empty());
    journal.append(points[0]);
    journal.append(points[1]);
  }
  const std::string whole = io::read_file(path_), third = line_of(points[2]);
  for (const std::size_t torn :
       {std::size_t{0}, std::size_t{1}, third.size() / 2, third.size() - 1}) {
    io::write_file(path_, whole + third.substr(0, torn));
    {
      StudyJournal journal(path_);
      EXPECT_EQ(points_in(journal).size(), 2u) << torn;
      EXPECT_EQ(journal.warnings().size(), torn == 0 ? 0u : 1u) << torn;
      EXPECT_EQ(io::read_file(path_), whole) << torn;
      journal.append(points[2]);
    }
    EXPECT_EQ(points_in(path_).size(), 3u) << torn;
  }
}

TEST_F(StudyJournalTest, AFirstLineThatIsTornIsCutOffToo) {
  const std::string line = line_of(sample_points()[0]);
  for (const std::size_t torn : {std::size_t{1}, std::size_t{9}, line.size() - 1}) {
    io::write_file(path_, line.substr(0, torn));
    EXPECT_TRUE(points_in(path_).empty());
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
    StudyJournal journal(path_);
    const std::vector<StudyPoint> believed = points_in(journal);
    ASSERT_EQ(believed.size(), 1u) << altered;
    EXPECT_EQ(believed[0].solver, points[1].solver);
    ASSERT_EQ(journal.warnings().size(), 1u) << altered;
    EXPECT_NE(journal.warnings()[0].find(": line 1 "), std::string::npos);
  }
}

TEST_F(StudyJournalTest, DoesNotBelieveLinesWithoutAChecksum) {
  const auto points = sample_points();
  std::string text;
  for (int i = 0; i < 7; ++i) text += to_json_line(points[0]) + "\n";
  io::write_file(path_, text + line_of(points[1]));
  StudyJournal journal(path_);
  EXPECT_EQ(points_in(journal).size(), 1u);
  EXPECT_EQ(journal.warnings(),
            (std::vector<std::string>{path_.string() +
                                      ": lines 1, 2, 3, 4, 5 and 2 more without a checksum, of a "
                                      "version before; measured anew"}));
  EXPECT_EQ(io::read_file(path_), text + line_of(points[1]));
}

TEST_F(StudyJournalTest, LeavesAloneWhatIsNoJournal) {
  for (const std::string text : {"a letter", "a letter\nof two lines\n", "{\"name\": 1}\n", "\n"}) {
    io::write_file(path_, text);
    EXPECT_THROW(points_in(path_), std::invalid_argument) << text;
    EXPECT_EQ(io::read_file(path_), text);
  }
  EXPECT_THROW(StudyJournal("/dev/null"), std::invalid_argument);
}

TEST_F(StudyJournalTest, RefusesALineThatHasNoEnd) {
  io::write_file(path_, std::string(3 << 20, 'x'));
  EXPECT_THROW(points_in(path_), std::invalid_argument);
  EXPECT_EQ(std::filesystem::file_size(path_), std::uintmax_t{3} << 20);
}

TEST_F(StudyJournalTest, ReadsLinesAcrossTheEndsOfItsPieces) {
  const auto points = sample_points();
  std::string text;
  std::size_t count = 0;
  for (; text.size() < (std::size_t{1} << 20); ++count) text += line_of(points[count % 3]);
  io::write_file(path_, text);
  const auto read = points_in(path_);
  ASSERT_EQ(read.size(), count);
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(read[i].solver, points[i % 3].solver);
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
