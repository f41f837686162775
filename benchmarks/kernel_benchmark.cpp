// The marked kernels: timed, as every Google Benchmark program, or asked one of these questions,
// whose answer is printed as JSON (or is the exit code):
//   --kernels             what there is: sizes, growth, physical limits
//   --environment         what this was built with
//   --accuracy            how exact the library is
//   --limits              the same as --kernels, with what the machine can do, measured
//   --count [NAME SIZE N]...  runs each kernel N times within measured_work(), after one run that
//                         fills caches and tables: for callgrind, which collects nothing else
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>

#include "benchmarks/kernels/accuracy.hpp"
#include "benchmarks/kernels/environment.hpp"
#include "benchmarks/kernels/kernel.hpp"
#include "benchmarks/kernels/limits.hpp"

namespace {

using namespace wavecurve::tracking;
using Json = nlohmann::ordered_json;

/// The self-test's copies are slowed: every so many runs of this kernel do the work twice.
#ifdef WAVECURVE_SLOWED_KERNEL
constexpr std::string_view slowed_kernel = WAVECURVE_SLOWED_KERNEL;
constexpr long twice_every = WAVECURVE_TWICE_EVERY;
void run(std::string_view name, const std::function<void()>& work) {
  static long runs = 0;
  work();
  if (name == slowed_kernel && ++runs % twice_every == 0) work();
}
#else
void run(std::string_view, const std::function<void()>& work) { work(); }
#endif

void time(benchmark::State& state, const Kernel& kernel, Eigen::Index size) {
  const std::function<void()> work = kernel.prepare(size);
  for (auto _ : state) {
    run(kernel.name, work);
    benchmark::ClobberMemory();
  }
  state.SetComplexityN(size);
}

}  // namespace

/// What callgrind is told to collect, so the name must be plain and the call must be one.
extern "C" [[gnu::noipa]] void measured_work(const char* name, const std::function<void()>& work,
                                             long iterations) {
  for (long i = 0; i < iterations; ++i) run(name, work);
}

namespace {

void count(const std::vector<std::string>& arguments) {
  for (std::size_t i = 1; i + 2 < arguments.size(); i += 3) {
    const std::string& name = arguments[i];
    const std::function<void()> work = find_kernel(name).prepare(std::stol(arguments[i + 1]));
    work();
    measured_work(name.c_str(), work, std::stol(arguments[i + 2]));
  }
}

const char* to_string(Kernel::Growth growth) {
  switch (growth) {
    case Kernel::Growth::linear:
      return "N";
    case Kernel::Growth::linearithmic:
      return "N log N";
    case Kernel::Growth::none:
      break;
  }
  return "";
}

Json describe(const Kernel& kernel) {
  return {{"name", kernel.name},
          {"size", kernel.size},
          {"counted_runs", kernel.counted_runs},
          {"bytes", kernel.bytes},
          {"operations", kernel.operations},
          {"growth", to_string(kernel.growth)},
          {"sizes", kernel.sizes}};
}

Json list_kernels() {
  Json list = Json::array();
  for (const Kernel& kernel : kernels()) list.push_back(describe(kernel));
  for (const Kernel& kernel : plain_kernels()) {
    list.push_back(describe(kernel));
    list.back()["plain"] = true;
  }
  return list;
}

Json measure_limits() {
  constexpr double beyond_caches = 512e6;
  const double peak = arithmetic_peak(), stream = copy_seconds(beyond_caches);
  Json json = {{"operations_per_second", peak}, {"bytes_per_second", beyond_caches / stream}};
  for (const Kernel& kernel : kernels()) {
    Json& limit = json["kernels"][kernel.name];
    if (kernel.bytes > 0) limit["copy_seconds"] = copy_seconds(kernel.bytes);
    if (kernel.operations > 0) limit["arithmetic_seconds"] = kernel.operations / peak;
  }
  return json;
}

Json accuracy() {
  Json json = Json::object();
  for (const Accuracy& entry : measure_accuracy()) {
    json[entry.name] = {{"kind", entry.kind}, {"value", entry.value}};
  }
  return json;
}

int print(const Json& json) {
  std::puts(json.dump(1).c_str());
  return std::fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

int run_benchmarks(int argc, char** argv) {
  for (const Kernel& kernel : kernels()) {
    std::vector<Eigen::Index> sizes = kernel.sizes;
    if (sizes.empty()) sizes = {kernel.size};
    for (const Eigen::Index size : sizes) {
      benchmark::RegisterBenchmark((kernel.name + "/" + std::to_string(size)).c_str(),
                                   [kernel, size](auto& state) { time(state, kernel, size); });
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return EXIT_FAILURE;
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}

int answer(const std::vector<std::string>& arguments, int argc, char** argv) {
  const std::string question = arguments.empty() ? "" : arguments[0];
  if (question == "--kernels") return print(list_kernels());
  if (question == "--environment") return print(environment());
  if (question == "--accuracy") return print(accuracy());
  if (question == "--limits") return print(measure_limits());
  if (question == "--count") return count(arguments), EXIT_SUCCESS;
  return run_benchmarks(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return answer({argv + 1, argv + argc}, argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kernel_benchmark: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
