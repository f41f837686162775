#include "benchmarks/tracking/instruction_counts.hpp"

#include <future>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/run_program.hpp"
#include "wavecurve/io/files/detail/temporary.hpp"
#include "wavecurve/io/files/read_file.hpp"

#include "benchmarks/tracking/bootstrap.hpp"

namespace wavecurve::tracking {

namespace {

namespace fs = std::filesystem;

/// The "totals:" of each part; events in the order Ir Dr Dw, the first three of the simulator.
std::vector<Counts> read_totals(const std::string& text) {
  std::vector<Counts> totals;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("events:") && !line.starts_with("events: Ir Dr Dw")) {
      throw std::runtime_error("valgrind counts other events than expected: " + line);
    }
    if (!line.starts_with("totals:")) continue;
    std::istringstream numbers(line.substr(line.find(':') + 1));
    Counts counts;
    numbers >> counts.instructions >> counts.data_reads >> counts.data_writes;
    totals.push_back(counts);
  }
  return totals;
}

std::vector<Counts> count_once(const fs::path& program, const std::vector<CountedKernel>& kernels) {
  const io::Temporary folder(fs::temp_directory_path() / "counts", io::Temporary::Kind::folder);
  std::vector<std::string> command{"valgrind",
                                   "--tool=callgrind",
                                   "--cache-sim=yes",
                                   "--collect-atstart=no",
                                   "--toggle-collect=measured_work",
                                   "--dump-after=measured_work",
                                   "--combine-dumps=yes",
                                   "--callgrind-out-file=" + (folder.path() / "counts").string(),
                                   program.string(),
                                   "--count"};
  for (const CountedKernel& kernel : kernels) {
    command.insert(command.end(),
                   {kernel.name, std::to_string(kernel.size), std::to_string(kernel.runs)});
  }
  io::output_of(command);
  std::vector<Counts> counts = read_totals(io::read_file(folder.path() / "counts"));
  // The last part is what comes after the last kernel: nothing.
  if (counts.size() < kernels.size()) {
    throw std::runtime_error(fmt::format("valgrind counted {} of {} kernels of {}", counts.size(),
                                         kernels.size(), program.string()));
  }
  counts.resize(kernels.size());
  return counts;
}

double median_of(const std::vector<std::vector<Counts>>& runs, std::size_t kernel,
                 double Counts::*quantity) {
  std::vector<double> values;
  for (const auto& run : runs) values.push_back(run[kernel].*quantity);
  return median(std::move(values));
}

}  // namespace

std::vector<Counts> count_instructions(const fs::path& program,
                                       const std::vector<CountedKernel>& kernels, int processes) {
  std::vector<std::future<std::vector<Counts>>> pending;
  for (int i = 0; i < processes; ++i) {
    pending.push_back(std::async(std::launch::async, count_once, program, kernels));
  }
  std::vector<std::vector<Counts>> runs;
  for (auto& run : pending) runs.push_back(run.get());
  std::vector<Counts> result;
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    const auto n = static_cast<double>(kernels[i].runs);
    result.push_back({median_of(runs, i, &Counts::instructions) / n,
                      median_of(runs, i, &Counts::data_reads) / n,
                      median_of(runs, i, &Counts::data_writes) / n});
  }
  return result;
}

std::string valgrind_version() {
  std::string version = io::output_of({"valgrind", "--version"});
  while (!version.empty() && version.back() == '\n') version.pop_back();
  return version;
}

}  // namespace wavecurve::tracking
