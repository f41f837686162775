#include "benchmarks/tracking/backfill.hpp"

#include <stdexcept>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/detail/run_program.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "benchmarks/tracking/record.hpp"

namespace wavecurve::tracking {
namespace {

namespace fs = std::filesystem;

class BackfillTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      io::run_program({"git", "--version"});
    } catch (const std::system_error&) {
      GTEST_SKIP() << "git is not there";
    }
    fs::create_directories(root_ / "lib");
    fs::create_directories(root_ / "benchmarks");
    git({"init", "--quiet"});
  }
  void TearDown() override { fs::remove_all(root_); }

  std::string git(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(),
                     {"git", "-c", "user.name=n", "-c", "user.email=e@localhost"});
    const std::string text = io::output_of(arguments, root_);
    return text.substr(0, text.find('\n'));
  }

  /// The commit that changes a file.
  std::string change(const fs::path& file) {
    io::write_file(root_ / file, std::to_string(++changes_));
    git({"add", "--all"});
    git({"commit", "--quiet", "-m", "a change"});
    return git({"rev-parse", "HEAD"});
  }

  const fs::path root_ =
      fs::temp_directory_path() / ("wavecurve backfill " + std::to_string(::getpid()));
  int changes_ = 0;
};

TEST_F(BackfillTest, SamplesWhatChangedTheLibraryEvenlyWithBothEnds) {
  change("lib/a.cpp");  // no kernels yet
  std::vector<std::string> all = {change("benchmarks/kernel_benchmark.cpp")};
  for (int i = 0; i < 8; ++i) {
    change("README.md");
    all.push_back(change("lib/a.cpp"));
  }
  const fs::path history = root_ / "benchmarks" / "history";
  EXPECT_EQ(revisions_to_record(root_, history, 100), all);
  EXPECT_EQ(revisions_to_record(root_, history, 3),
            (std::vector<std::string>{all[0], all[4], all[8]}));
  EXPECT_EQ(revisions_to_record(root_, history, 1), std::vector<std::string>{all[0]});
  append_record(
      history,
      {{"schema", 1}, {"date", "2026-01-31T12:00:00Z"}, {"revision", {{"commit", all[4]}}}});
  EXPECT_EQ(revisions_to_record(root_, history, 3), (std::vector<std::string>{all[0], all[8]}));
}

TEST_F(BackfillTest, RefusesWhatIsNoClone) {
  EXPECT_THROW(revisions_to_record(root_ / "lib", "history", 3), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::tracking
