#include <regex>
#include <string>

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

using Version = ProgramTest;

TEST_F(Version, TellsWhatTheProgramIsMadeOf) {
  const ProgramRun version = wavecurve("--version");
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_TRUE(
      std::regex_match(version.out, std::regex("wavecurve \\d+\\.\\d+\\.\\d+\n"
                                               "revision  \\S+\n"
                                               "compiler  (GNU|Clang) \\d+\\.\\S+\n"
                                               "FLINT     \\d+\\.\\S+\n"
                                               "Eigen     \\d+\\.\\d+\\.\\d+\n"
                                               "Highway   \\d+\\.\\d+\\.\\d+, using [A-Z]+\\S*\n")))
      << version.out;
}

/// What the build writes is the revision of the sources it was made from, or "unknown".
TEST_F(Version, TellsTheRevisionOfAClone) {
  const std::string script =
      "cmake -D SOURCE_DIR=. -D OUTPUT=revision.cpp -P '" WAVECURVE_SOURCE_DIR
      "/tools/package/revision.cmake'";
  const auto revision_after = [&](const std::string& commands) {
    const ProgramRun made =
        run("cd '" + folder_.string() + "' && { " + commands + " } && " + script);
    EXPECT_EQ(made.exit_code, 0) << made.err;
    const std::string text = io::read_file(folder_ / "revision.cpp");
    const std::size_t start = text.find(" = \"") + 4;
    return text.substr(start, text.find('"', start) - start);
  };
  EXPECT_EQ(revision_after("true;"), "unknown");
  if (run("git --version").exit_code != 0) GTEST_SKIP() << "no git";
  const std::string git = "git -c user.name=n -c user.email=e@localhost ";
  EXPECT_EQ(revision_after("git init -q . && echo 1 >a && git add a && " + git +
                           "commit -qm first && " + git + "tag -m t v1;"),
            "v1");
  EXPECT_EQ(revision_after("echo 2 >a;"), "v1-dirty");
}

}  // namespace
}  // namespace wavecurve::tools
