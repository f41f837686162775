#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wavecurve::io {

struct ProgramRun {
  int exit_code;  ///< -1: ended by a signal
  std::string out, err;
};

/// Runs a program, found through PATH, and waits for its end. Its stdin is /dev/null, LC_ALL is C,
/// and the working directory is `directory` (ours if that is empty); `environment` adds to ours
/// (NAME=VALUE). Throws std::system_error if it cannot be started.
ProgramRun run_program(const std::vector<std::string>& command,
                       const std::filesystem::path& directory = {},
                       const std::vector<std::string>& environment = {});

/// What it prints. Throws std::runtime_error with the end of its complaint unless it exits with 0.
std::string output_of(const std::vector<std::string>& command,
                      const std::filesystem::path& directory = {},
                      const std::vector<std::string>& environment = {});

}  // namespace wavecurve::io
