#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve::tools {

struct ProgramRun {
  int exit_code;
  std::string out, err;
};

/// A fixture for tests that run the program as a user does, in a folder of their own.
class ProgramTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Runs a shell command line.
  ProgramRun run(const std::string& command) const {
    const auto out = folder_ / "stdout", err = folder_ / "stderr";
    const int status =
        std::system((command + " >'" + out.string() + "' 2>'" + err.string() + "'").c_str());
    return {WEXITSTATUS(status), io::read_file(out), io::read_file(err)};
  }

  /// Runs `wavecurve ARGUMENTS` inside the folder.
  ProgramRun wavecurve(const std::string& arguments) const {
    return run("cd '" + folder_.string() + "' && '" WAVECURVE_PROGRAM "' " + arguments);
  }

  /// Expects one line on the error stream that holds the text, nothing on the other, and exit
  /// code 2.
  void expect_refusal(const std::string& arguments, const std::string& text) const {
    const ProgramRun refused = wavecurve(arguments);
    EXPECT_EQ(refused.exit_code, 2) << arguments;
    EXPECT_EQ(refused.out, "") << arguments;
    EXPECT_NE(refused.err.find(text), std::string::npos) << arguments << ": " << refused.err;
    EXPECT_EQ(refused.err.find('\n'), refused.err.size() - 1) << arguments << ": " << refused.err;
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("wavecurve_test_" + std::to_string(::getpid()));
};

}  // namespace wavecurve::tools
