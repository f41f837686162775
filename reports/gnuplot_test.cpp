#include "reports/gnuplot.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::reports {
namespace {

namespace fs = std::filesystem;

class Gnuplot : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(directory); }
  void TearDown() override { fs::remove_all(directory); }

  const fs::path directory =
      fs::temp_directory_path() / ("wavecurve_gnuplot_" + std::to_string(getpid()));
  verification::Chart chart{"decay",
                            {"Decay", {"n", "a\tvalue"}, {{"1", "1.0"}, {"2", "0.5"}}},
                            "plot data using 1:2 with lines"};
};

TEST_F(Gnuplot, DrawsAndLeavesWhatIsNeededToDrawAnew) {
  draw_chart(chart, directory);
  const std::string picture = io::read_file(directory / "decay.svg");
  EXPECT_NE(picture.find("</svg>"), std::string::npos);
  EXPECT_NE(picture.find("a value"), std::string::npos) << "the column's name titles the line";
  EXPECT_EQ(io::read_file(directory / "decay.dat"), "n\ta value\n1\t1.0\n2\t0.5\n");

  fs::remove(directory / "decay.svg");
  const std::string command = "cd '" + directory.string() + "' && gnuplot decay.gp";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(io::read_file(directory / "decay.svg"), picture);
}

TEST_F(Gnuplot, ObeysNeitherTheUsersSettingsNorTheData) {
  io::write_file(directory / ".gnuplot", "set title 'of the user'\nsystem 'touch obeyed'\n");
  const std::string home = std::getenv("HOME");
  setenv("HOME", directory.c_str(), 1);
  chart.data.columns[1] = "`touch obeyed` \"a\" \x1b[2J";
  draw_chart(chart, directory);
  setenv("HOME", home.c_str(), 1);
  const std::string picture = io::read_file(directory / "decay.svg");
  EXPECT_EQ(picture.find("of the user"), std::string::npos);
  EXPECT_EQ(picture.find('\x1b'), std::string::npos);
  EXPECT_NE(picture.find("touch obeyed"), std::string::npos) << "it is the line's title";
  EXPECT_FALSE(fs::exists(directory / "obeyed"));
}

TEST_F(Gnuplot, ShowsAnErrorAndNotTheWarningBeforeIt) {
  chart.script = "set xrange [1:1]\nplot data using 1:7\nplot nothing_known";
  try {
    draw_chart(chart, directory);
    FAIL();
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("arning"), std::string::npos) << message;
    EXPECT_NE(message.find("\"decay.gp\" line "), std::string::npos) << message;
  }
}

TEST_F(Gnuplot, AnEmptyFirstCellKeepsItsColumn) {
  chart.data.rows = {{"", "1"}, {"2", ""}};
  chart.script = "plot sin(x)";
  draw_chart(chart, directory);
  EXPECT_EQ(io::read_file(directory / "decay.dat"), "n\ta value\n\t1\n2\t\n");
}

TEST_F(Gnuplot, AFailureNamesItsFirstComplaintAndLeavesNoPicture) {
  draw_chart(chart, directory);
  for (const char* script : {"plot nothing_known", "no such command", "plot data using 7:8"}) {
    chart.script = script;
    try {
      draw_chart(chart, directory);
      FAIL() << script;
    } catch (const std::runtime_error& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("\"decay.gp\" line "), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
    EXPECT_FALSE(fs::exists(directory / "decay.err"));
  }
}

TEST_F(Gnuplot, AMissingProgramIsNamedWithItsPackage) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", directory.c_str(), 1);
  try {
    draw_chart(chart, directory);
    ADD_FAILURE() << "drawn without gnuplot";
  } catch (const std::system_error& error) {
    EXPECT_NE(std::string(error.what()).find("gnuplot-nox"), std::string::npos);
  }
  setenv("PATH", path.c_str(), 1);
}

/// As after a disk that is full, which gnuplot does not notice.
TEST_F(Gnuplot, APictureThatIsNotWholeIsRefused) {
  const std::string path = std::getenv("PATH");
  const fs::path bin = directory / "bin";
  fs::create_directory(bin);
  io::write_file(bin / "gnuplot", "#!/bin/sh\nexport PATH='" + path +
                                      "'\ngnuplot \"$@\"; truncate -s 2000 decay.svg\n");
  fs::permissions(bin / "gnuplot", fs::perms::owner_all);
  setenv("PATH", (bin.string() + ":" + path).c_str(), 1);
  try {
    draw_chart(chart, directory);
    ADD_FAILURE() << "half a picture";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("decay.svg"), std::string::npos) << error.what();
  }
  setenv("PATH", path.c_str(), 1);
}

TEST_F(Gnuplot, ADirectoryThatIsNotThereIsNamed) {
  EXPECT_THROW(draw_chart(chart, directory / "none"), std::system_error);
}

}  // namespace
}  // namespace wavecurve::reports
