#include "benchmarks/tracking/make_record.hpp"

#include <array>
#include <chrono>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "wavecurve/io/files/detail/json_place.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/io/files/detail/run_program.hpp"

#include "benchmarks/tracking/machine_fingerprint.hpp"
#include "benchmarks/tracking/marked_kernels.hpp"

namespace wavecurve::tracking {

namespace {

std::vector<CountedKernel> counted_kernels(const Build& build) {
  std::vector<CountedKernel> list;
  for (const MarkedKernel& kernel : marked_kernels(build)) {
    if (!kernel.is_plain) list.push_back({kernel.name, kernel.size, kernel.counted_runs});
  }
  return list;
}

Json as_json(const std::vector<CountedKernel>& kernels, const std::vector<Counts>& counts) {
  Json json = Json::object();
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    json[kernels[i].name] = {{"size", kernels[i].size},
                             {"instructions", counts[i].instructions},
                             {"data_reads", counts[i].data_reads},
                             {"data_writes", counts[i].data_writes}};
  }
  return json;
}

/// The vectors that programs find on the processor that valgrind plays.
std::string vectors_in_valgrind(const Build& build) {
  const std::string text = io::output_of(
      {"valgrind", "--tool=none", "-q", build.kernel_program().string(), "--environment"});
  const Json environment = io::parse_ordered_json(text);
  return io::OrderedJsonPlace(environment).at("vectors").text();
}

/// Whether it runs, too: some containers do not let it.
bool has_valgrind() {
  try {
    return io::run_program({"valgrind", "--tool=none", "-q", "true"}).exit_code == 0;
  } catch (const std::system_error&) {
    return false;
  }
}

/// All repetitions of a benchmark as one entry: names as Google Benchmark has them, numbers as
/// lists.
Json joined(const BenchmarkName& benchmark, const Json& runs) {
  static constexpr std::array known{"name",
                                    "family_index",
                                    "per_family_instance_index",
                                    "run_name",
                                    "run_type",
                                    "repetitions",
                                    "repetition_index",
                                    "threads",
                                    "time_unit",
                                    "iterations",
                                    "real_time",
                                    "cpu_time"};
  Json entry = {{"program", benchmark.program},
                {"name", benchmark.name},
                {"time_unit", runs.at(0).at("time_unit")}};
  for (const Json& run : runs) {
    for (const char* key : {"real_time", "cpu_time", "iterations"})
      entry[key].push_back(run.at(key));
    for (const auto& [key, value] : run.items()) {
      const bool is_counter = std::find(known.begin(), known.end(), key) == known.end();
      if (is_counter && value.is_number()) entry["counters"][key].push_back(value);
    }
  }
  return entry;
}

Json time_all(const Build& build, const RecordOptions& options, const Say& say) {
  Json list = Json::array();
  for (const auto& program : build.all_programs()) {
    for (const BenchmarkName& benchmark : list_benchmarks(program, options.filter)) {
      say(benchmark.program + " " + benchmark.name);
      try {
        list.push_back(joined(benchmark, run_benchmark(program, benchmark.name, options.seconds,
                                                       options.repetitions)));
      } catch (const std::runtime_error& error) {
        list.push_back(
            {{"program", benchmark.program}, {"name", benchmark.name}, {"failed", error.what()}});
      }
    }
  }
  return list;
}

}  // namespace

Json measure_counts(const Build& build, int processes) {
  Json json = Json::object();
  if (!build.has_kernels()) return json;
  json["environment"] = ask(build, "--environment");
  json["accuracy"] = ask(build, "--accuracy");
  if (!has_valgrind()) return json;
  json["valgrind"] = {{"version", valgrind_version()}, {"vectors", vectors_in_valgrind(build)}};
  const std::vector<CountedKernel> kernels = counted_kernels(build);
  json["kernels"] =
      as_json(kernels, count_instructions(build.kernel_program(), kernels, processes));
  return json;
}

Json make_record(const Build& build, const RecordOptions& options, const Say& say) {
  Json record = {{"schema", record_schema},
                 {"date", date_now()},
                 {"revision", build.revision},
                 {"machine", machine_fingerprint()}};
  say("counting instructions");
  record.update(measure_counts(build));
  if (options.has_limits && build.has_kernels()) {
    say("measuring what the machine can do");
    record["limits"] = ask(build, "--limits");
  }
  if (options.is_timed) record["benchmarks"] = time_all(build, options, say);
  return record;
}

std::string date_now() {
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

}  // namespace wavecurve::tracking
