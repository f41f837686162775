#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "benchmarks/tracking/bootstrap.hpp"
#include "benchmarks/tracking/record.hpp"

namespace wavecurve::tracking {

/// One benchmark of a Google Benchmark program; `program` is its file name.
struct BenchmarkName {
  std::string program, name;
  auto operator<=>(const BenchmarkName&) const = default;
};

/// Told what is being done, for a person who waits.
using Say = std::function<void(const std::string&)>;

/// The benchmarks of a program whose name matches the regular expression.
std::vector<BenchmarkName> list_benchmarks(const std::filesystem::path& program,
                                           const std::string& filter = ".");

/// Runs one benchmark in a process of its own, for at least so many seconds each repetition, and
/// returns the entries that Google Benchmark writes, one a repetition. Processor time is what is
/// compared: on a shared machine others take wall time, not this.
/// Throws std::runtime_error where the program or the benchmark fails.
Json run_benchmark(const std::filesystem::path& program, const std::string& name, double seconds,
                   int repetitions = 1);

/// Processor time of one iteration, in seconds: the least of five repetitions, which share the
/// given time, since whoever else uses the machine only ever adds. Throws as above.
double time_once(const std::filesystem::path& program, const std::string& name, double seconds);

/// One of Google Benchmark's ns, us, ms and s.
double seconds_of_unit(const std::string& unit);

/// Two things to be timed against each other, each by a function that runs it once in a process of
/// its own and returns seconds.
struct TimedPair {
  std::string name;
  std::function<double()> a, b;
};

/// So many blocks of each pair: in each round the pairs come in an order of their own, drawn at
/// random, and each is timed A B B A or B A A B, drawn too.
std::vector<std::vector<Block>> time_interleaved(const std::vector<TimedPair>& pairs, int blocks,
                                                 std::uint64_t seed, const Say& say);

/// The same of each benchmark, programs of the folder `a` against those of `b`.
std::map<BenchmarkName, std::vector<Block>> time_interleaved(
    const std::filesystem::path& a, const std::filesystem::path& b,
    const std::vector<BenchmarkName>& benchmarks, int blocks, double seconds, std::uint64_t seed,
    const Say& say);

}  // namespace wavecurve::tracking
