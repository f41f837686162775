#include "wavecurve/io/files/detail/run_program.hpp"

#include <stdexcept>

#include "wavecurve/io/files/detail/child_process.hpp"

namespace wavecurve::io {

namespace fs = std::filesystem;

ProgramRun run_program(const std::vector<std::string>& command, const fs::path& directory,
                       const std::vector<std::string>& environment) {
  ChildProcess child(command, {.directory = directory, .variables = environment});
  const int exit_code = child.finish();
  return {exit_code, child.out(), child.err()};
}

std::string output_of(const std::vector<std::string>& command, const fs::path& directory,
                      const std::vector<std::string>& environment) {
  ProgramRun run = run_program(command, directory, environment);
  if (run.exit_code == 0) return std::move(run.out);
  constexpr std::size_t end_of_complaint = 600;
  std::string complaint = run.err.empty() ? run.out : run.err;
  if (complaint.size() > end_of_complaint) {
    complaint = "..." + complaint.substr(complaint.size() - end_of_complaint);
  }
  std::string line;
  for (const std::string& word : command) line += (line.empty() ? "" : " ") + word;
  throw std::runtime_error(line + " failed: " + complaint);
}

}  // namespace wavecurve::io
