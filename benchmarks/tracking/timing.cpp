#include "timing.hpp"

#include <algorithm>
#include <random>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <unistd.h>

#include <fmt/format.h>

#include "wavecurve/io/read_file.hpp"

#include "run_program.hpp"

namespace wavecurve::tracking {

namespace {

namespace fs = std::filesystem;

/// The name as a regular expression that matches nothing else.
std::string escaped(const std::string& name) {
  std::string pattern = "^";
  for (const char c : name) {
    if (std::string_view("^$.*+?()[]{}|\\").find(c) != std::string_view::npos) pattern += '\\';
    pattern += c;
  }
  return pattern + "$";
}

/// Reads what the program writes into a file, for some print tables of their own.
Json run_with_output(const fs::path& program, std::vector<std::string> arguments) {
  std::string file = (fs::temp_directory_path() / "wavecurve_benchmark.XXXXXX").string();
  const int descriptor = ::mkstemp(file.data());
  if (descriptor < 0)
    throw std::system_error(errno, std::generic_category(), "cannot make " + file);
  ::close(descriptor);
  arguments.insert(arguments.begin(), program.string());
  arguments.push_back("--benchmark_out=" + file);
  arguments.emplace_back("--benchmark_out_format=json");
  const ProgramRun run = run_program(arguments);
  const std::string text = io::read_file(file);
  fs::remove(file);
  Json json = Json::parse(text, nullptr, false);
  if (run.exit_code != 0 || !json.is_object()) {
    throw std::runtime_error(program.string() + " failed: " + run.err);
  }
  return json;
}

}  // namespace

double seconds_of_unit(const std::string& unit) {
  if (unit == "ns") return 1e-9;
  if (unit == "us") return 1e-6;
  return unit == "ms" ? 1e-3 : 1;
}

std::vector<BenchmarkName> list_benchmarks(const fs::path& program, const std::string& filter) {
  const std::regex wanted(filter);
  std::vector<BenchmarkName> names;
  std::istringstream lines(output_of({program.string(), "--benchmark_list_tests"}));
  for (std::string line; std::getline(lines, line);) {
    // Lines with blanks are a program's own.
    const bool is_name = !line.empty() && line.find(' ') == std::string::npos;
    if (is_name && std::regex_search(line, wanted)) {
      names.push_back({program.filename().string(), line});
    }
  }
  return names;
}

Json run_benchmark(const fs::path& program, const std::string& name, double seconds,
                   int repetitions) {
  // Names that are listed may end in /iterations:1 or /repeats:9, and are matched whole.
  const Json all = run_with_output(program, {"--benchmark_filter=" + escaped(name),
                                             fmt::format("--benchmark_min_time={}", seconds),
                                             fmt::format("--benchmark_repetitions={}", repetitions),
                                             "--benchmark_report_aggregates_only=false"});
  Json runs = Json::array();
  for (const Json& run : all["benchmarks"]) {
    if (run.value("error_occurred", false)) {
      throw std::runtime_error(name + ": " + run.value("error_message", "failed"));
    }
    if (run.value("run_type", "iteration") == "iteration") runs.push_back(run);
  }
  if (runs.empty()) throw std::runtime_error(program.string() + " has no benchmark " + name);
  return runs;
}

double time_once(const fs::path& program, const std::string& name, double seconds) {
  constexpr int repetitions = 5;
  double least = std::numeric_limits<double>::infinity();
  for (const Json& run : run_benchmark(program, name, seconds / repetitions, repetitions)) {
    least = std::min(least, run["cpu_time"].get<double>() *
                                seconds_of_unit(run["time_unit"].get<std::string>()));
  }
  return least;
}

std::map<BenchmarkName, std::vector<Block>> time_interleaved(const fs::path& a, const fs::path& b,
                                                             std::vector<BenchmarkName> benchmarks,
                                                             int blocks, double seconds,
                                                             std::uint64_t seed, const Say& say) {
  std::mt19937_64 random(seed);
  std::map<BenchmarkName, std::vector<Block>> times;
  for (int round = 0; round < blocks; ++round) {
    say(fmt::format("timing, block {} of {}", round + 1, blocks));
    std::ranges::shuffle(benchmarks, random);
    for (const BenchmarkName& benchmark : benchmarks) {
      const auto time = [&](const fs::path& folder) {
        return time_once(folder / benchmark.program, benchmark.name, seconds);
      };
      Block block{};
      if (random() % 2 == 0) {
        block.a_first = time(a);
        block.b_first = time(b);
        block.b_second = time(b);
        block.a_second = time(a);
      } else {
        block.b_first = time(b);
        block.a_first = time(a);
        block.a_second = time(a);
        block.b_second = time(b);
      }
      times[benchmark].push_back(block);
    }
  }
  return times;
}

}  // namespace wavecurve::tracking
