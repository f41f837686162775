// Lists of numbers identified among all known columns: the first, for which the columns and the index are made
// (what a run of `wavecurve identify` takes; a list and a second at most), and those after it.
#include <algorithm>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "verification/identify/identify.hpp"

namespace wavecurve::verification {
namespace {

/// The longest column of the filter, backwards, times -2, with 12 digits.
NumberList changed_list(const std::string& filter) {
  const KnownColumn* longest = nullptr;
  for (const KnownColumn& column : known_columns()) {
    if (column.filter != filter) continue;
    if (!longest || column.values.size() > longest->values.size()) longest = &column;
  }
  NumberList list;
  for (const double value : longest->values.taps) {
    list.numbers.push_back(parse_printed_number(fmt::format("{:.12g}", -2 * value)));
  }
  std::reverse(list.numbers.begin(), list.numbers.end());
  return list;
}

void first_list(benchmark::State& state) {
  NumberList list;
  for (const char* tap : {"0.48296291", "0.83651630", "0.22414387", "-0.12940952"}) {
    list.numbers.push_back(parse_printed_number(tap));
  }
  for (auto _ : state) benchmark::DoNotOptimize(identify(list));
}
BENCHMARK(first_list)->Iterations(1)->Unit(benchmark::kMillisecond);

void next_list(benchmark::State& state, const std::string& filter) {
  const NumberList list = changed_list(filter);
  for (auto _ : state) benchmark::DoNotOptimize(identify(list));
  state.counters["numbers"] = static_cast<double>(list.numbers.size());
}
BENCHMARK_CAPTURE(next_list, db2, "db2")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(next_list, db10, "db10")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(next_list, coif5, "coif5")->Unit(benchmark::kMicrosecond);

void nearest_of_an_unknown_list(benchmark::State& state) {
  NumberList list;
  for (int i = 0; i < 20; ++i) {
    list.numbers.push_back(parse_printed_number(fmt::format("0.{}", 137 + 41 * i)));
  }
  for (auto _ : state) benchmark::DoNotOptimize(nearest_columns(list, {}));
}
BENCHMARK(nearest_of_an_unknown_list)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace wavecurve::verification
