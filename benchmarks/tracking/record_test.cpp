#include "benchmarks/tracking/record.hpp"

#include <chrono>
#include <csignal>
#include <fstream>
#include <random>
#include <stdexcept>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::tracking {
namespace {

namespace fs = std::filesystem;

class RecordTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  Json record(const std::string& date = "2026-01-31T12:00:00Z") const {
    return {{"schema", 1}, {"date", date}, {"revision", {{"commit", "0123456789abcdef"}}}};
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("wavecurve records " + std::to_string(::getpid()));
};

TEST_F(RecordTest, IsAppendedAndReadAgain) {
  const fs::path second = append_record(folder_ / "history", record("2026-02-01T00:00:00Z"));
  const fs::path first = append_record(folder_ / "history", record());
  EXPECT_EQ(first.filename(), "2026-01-31T12-00-00Z-0123456789.json");
  EXPECT_EQ(read_record(first), record());
  const auto history = read_history(folder_ / "history").records;
  ASSERT_EQ(history.size(), 2u);
  EXPECT_EQ(history[0], record());
  EXPECT_EQ(history[1], read_record(second));
  EXPECT_TRUE(read_history(folder_ / "none").records.empty());
}

TEST_F(RecordTest, StandsWhereItsRevisionDoesWheneverItWasMeasured) {
  const auto add = [&](const char* measured, const char* committed) {
    Json one = record(measured);
    one["revision"]["date"] = committed;
    append_record(folder_, one);
  };
  add("2026-03-01T00:00:00Z", "2026-01-05T01:30:00+02:00");  // of the 4th, in UTC
  add("2026-03-02T00:00:00Z", "2026-01-04T22:00:00+00:00");
  add("2026-03-03T00:00:00Z", "2026-01-04T19:00:00-04:00");
  append_record(folder_, record("2026-01-05T00:00:00Z"));
  std::vector<std::string> dates;
  for (const Json& one : read_history(folder_).records) dates.push_back(one.at("date"));
  EXPECT_EQ(dates, (std::vector<std::string>{"2026-03-02T00:00:00Z", "2026-03-03T00:00:00Z",
                                             "2026-03-01T00:00:00Z", "2026-01-05T00:00:00Z"}));
}

TEST_F(RecordTest, NeverTakesThePlaceOfAnother) {
  const fs::path first = append_record(folder_, record());
  Json other = record();
  other["note"] = "the same second";
  EXPECT_NE(append_record(folder_, other), first);
  EXPECT_EQ(read_record(first), record());
  EXPECT_EQ(read_history(folder_).records.size(), 2u);
}

TEST_F(RecordTest, KeepsFieldsThatItDoesNotKnow) {
  Json extended = record();
  extended["weather"] = {{"wind", 3}, {"cloud", {1, 2}}};
  const Json read = read_record(append_record(folder_, extended));
  EXPECT_EQ(read_record(append_record(folder_ / "again", read)), extended);
}

TEST_F(RecordTest, RefusesWhatIsNone) {
  for (const char* text : {"", "{", "[]", "{}", R"({"schema": "one"})", R"({"schema": 99})"}) {
    io::write_file(folder_ / "x.json", text);
    EXPECT_THROW(read_record(folder_ / "x.json"), std::invalid_argument) << text;
  }
  append_record(folder_, record());
  const History history = read_history(folder_);
  EXPECT_EQ(history.records.size(), 1u);
  ASSERT_EQ(history.refused.size(), 1u);
  EXPECT_NE(history.refused[0].find("x.json is no record"), std::string::npos);
  EXPECT_THROW(read_record(folder_ / "none.json"), std::invalid_argument);
}

TEST_F(RecordTest, AKilledRunLeavesTheHistoryValid) {
  std::mt19937_64 random(1996);
  Json large = record();
  large["filling"] = std::string(300000, 'x');
  std::size_t least = 0;
  // A slow machine may need more rounds until one record is whole.
  for (int round = 0; round < 25 || (least == 0 && round < 500); ++round) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      while (true) append_record(folder_, large);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(500 + random() % 20000));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    for (const auto& entry : fs::directory_iterator(folder_)) {
      if (entry.path().extension() != ".json") continue;
      EXPECT_EQ(read_record(entry.path()), large);
    }
    const std::size_t count = read_history(folder_).records.size();
    EXPECT_GE(count, least);
    least = count;
  }
  EXPECT_GT(least, 0u);
}

/// Appends records until one fails; how many are whole then.
void fill(const fs::path& folder, const Json& record) {
  std::size_t appended = 0;
  try {
    for (; appended < 1000; ++appended) append_record(folder, record);
    FAIL() << "the disk is not full";
  } catch (const std::system_error&) {
  }
  EXPECT_EQ(read_history(folder).records.size(), appended);
  for (const auto& entry : fs::directory_iterator(folder)) {
    EXPECT_EQ(entry.path().extension(), ".json") << "something is left over";
  }
}

TEST_F(RecordTest, AFullDiskLeavesTheHistoryValid) {
  Json large = record();
  large["filling"] = std::string(50000, 'x');
  if (::mount("tmpfs", folder_.c_str(), "tmpfs", 0, "size=256k") != 0) {
    GTEST_SKIP() << "no file system can be mounted here; a limited file size is tested instead";
  }
  fill(folder_, large);
  ::umount(folder_.c_str());
}

TEST_F(RecordTest, AFileThatMayNotGrowLeavesTheHistoryValid) {
  append_record(folder_, record());
  Json large = record();
  large["filling"] = std::string(50000, 'x');
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{10000, before.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(append_record(folder_, large), std::system_error);
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(read_history(folder_).records.size(), 1u);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace wavecurve::tracking
