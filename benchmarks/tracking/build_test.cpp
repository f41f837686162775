#include "benchmarks/tracking/build.hpp"

#include <stdexcept>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/detail/run_program.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::tracking {
namespace {

namespace fs = std::filesystem;

/// A repository with a benchmark program of its own, in a path with blanks.
class BuildTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* program : {"git", "cmake", "ninja"}) {
      try {
        io::run_program({program, "--version"});
      } catch (const std::system_error&) {
        GTEST_SKIP() << program << " is not there";
      }
    }
    fs::create_directories(root_ / "benchmarks");
    io::write_file(root_ / "CMakeLists.txt",
                   "cmake_minimum_required(VERSION 3.25)\nproject(tiny LANGUAGES CXX)\n"
                   "set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)\n"
                   "add_executable(tiny_benchmark benchmarks/tiny_benchmark.cpp)\n");
    io::write_file(root_ / ".gitignore", "/build/\n");
    source("return 0;");
    git({"init", "--quiet"});
    commit();
  }
  void TearDown() override { fs::remove_all(root_); }

  void source(const std::string& body) const {
    io::write_file(root_ / "benchmarks" / "tiny_benchmark.cpp", "int main() { " + body + " }\n");
  }
  void git(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(),
                     {"git", "-c", "user.name=n", "-c", "user.email=e@localhost"});
    io::output_of(arguments, root_);
  }
  void commit() const {
    git({"add", "--all"});
    git({"commit", "--quiet", "-m", "a change"});
  }
  static int result(const Build& build) {
    return io::run_program({(build.programs / "tiny_benchmark").string()}).exit_code;
  }

  const fs::path root_ =
      fs::temp_directory_path() / ("wavecurve build " + std::to_string(::getpid()));
};

TEST_F(BuildTest, BuildsRevisionsAndTheWorkingTree) {
  source("return 5;");
  commit();
  const Build before = build_revision(root_, "HEAD~1", Programs::all);
  const Build after = build_revision(root_, "HEAD", Programs::all);
  EXPECT_EQ(result(before), 0);
  EXPECT_EQ(result(after), 5);
  EXPECT_EQ(after.revision["subject"], "a change");

  EXPECT_EQ(build_revision(root_, "", Programs::all).programs, after.programs);
  source("return 7;");
  const std::string status = io::output_of({"git", "status", "--short"}, root_);
  const Build now = build_revision(root_, "", Programs::all);
  EXPECT_EQ(result(now), 7);
  EXPECT_EQ(now.revision["is_dirty"], true);
  EXPECT_EQ(io::output_of({"git", "status", "--short"}, root_), status);
  EXPECT_EQ(result(before), 0);
}

TEST_F(BuildTest, LeavesAFolderThatIsNoCloneAsItIs) {
  fs::remove_all(root_ / ".git");
  EXPECT_THROW(build_revision(root_, "HEAD", Programs::all), std::invalid_argument);
  EXPECT_THROW(build_revision(root_, "", Programs::all), std::invalid_argument);
  EXPECT_FALSE(fs::exists(root_ / "build"));
}

TEST_F(BuildTest, RefusesWhatItCannotBuild) {
  EXPECT_THROW(build_revision(root_, "no-such", Programs::all), std::invalid_argument);
  EXPECT_THROW(build_revision(root_, "--all", Programs::all), std::invalid_argument);
  source("return");
  EXPECT_THROW(build_revision(root_, "", Programs::all), std::runtime_error);
  // A failure leaves nothing that would be taken for a build.
  source("return 3;");
  EXPECT_EQ(result(build_revision(root_, "", Programs::all)), 3);
  EXPECT_THROW(build_in(root_), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::tracking
