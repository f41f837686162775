#include "benchmarks/tracking/backfill.hpp"

#include <set>
#include <sstream>
#include <stdexcept>

#include "wavecurve/io/files/detail/run_program.hpp"

#include "benchmarks/tracking/record.hpp"

namespace wavecurve::tracking {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> changes(const fs::path& root) {
  std::istringstream lines(io::output_of({"git", "log", "--first-parent", "--reverse",
                                          "--format=%H", "HEAD", "--", "lib", "benchmarks"},
                                         root));
  std::vector<std::string> commits;
  for (std::string line; std::getline(lines, line);) commits.push_back(line);
  return commits;
}

bool has_kernels(const fs::path& root, const std::string& commit) {
  return io::run_program({"git", "cat-file", "-e", commit + ":benchmarks/kernel_benchmark.cpp"},
                         root)
             .exit_code == 0;
}

std::set<std::string> recorded(const fs::path& history) {
  std::set<std::string> commits;
  for (const Json& record : read_history(history).records) {
    commits.insert(record.at("revision").value("commit", ""));
  }
  return commits;
}

}  // namespace

std::vector<std::string> revisions_to_record(const fs::path& root, const fs::path& history,
                                             std::size_t count) {
  if (!fs::exists(root / ".git")) {
    throw std::invalid_argument(root.string() + " is no clone whose revisions could be built");
  }
  std::vector<std::string> all;
  for (const std::string& commit : changes(root)) {
    if (has_kernels(root, commit)) all.push_back(commit);
  }
  const std::set<std::string> there = recorded(history);
  std::vector<std::string> chosen;
  const std::size_t spaces = count > 1 ? count - 1 : 1;
  for (std::size_t i = 0; i < count && !all.empty(); ++i) {
    const std::string& commit = all[(all.size() - 1) * i / spaces];
    const bool is_again = !chosen.empty() && chosen.back() == commit;
    if (!is_again && !there.contains(commit)) chosen.push_back(commit);
  }
  return chosen;
}

}  // namespace wavecurve::tracking
