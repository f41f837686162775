// Frames of a morph, correspondence and crossings, each with its plain peer beside it.
#include <cmath>
#include <numbers>

#include <benchmark/benchmark.h>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/crossings.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/motion/contour_morph.hpp"

namespace wavecurve {
namespace {

using Eigen::Index;

/// A wavy ring, its waves and start depending on `leaves`.
Contour rosette(Index points, int leaves) {
  Contour contour(points, 2);
  for (Index i = 0; i < points; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    const double radius = 3 + std::cos(leaves * t) + 0.3 * std::sin(t + leaves);
    contour.row(i) << radius * std::cos(t), radius * std::sin(t);
  }
  return contour;
}

void linear_frame(benchmark::State& state, const char* filter) {
  const ContourPair pair{rosette(1024, 5), rosette(1024, 12)};
  ContourMorph morph(find_filter_bank(filter), 1024, 8, 1024);
  Contour points(1024, 2);
  for (auto _ : state) {
    morph.frame(pair, 0.3, detail_shares(Detail::blend, 0.25, 0.3), points);
    benchmark::DoNotOptimize(points.data());
  }
}
BENCHMARK_CAPTURE(linear_frame, D8, "db4")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(linear_frame, cubic_spline, "bspline4.4")->Unit(benchmark::kMicrosecond);

void correspondence(benchmark::State& state) {
  const Contour from = rosette(state.range(0), 5), to = rosette(state.range(0), 12);
  for (auto _ : state) benchmark::DoNotOptimize(best_shift(from, to, Rotation::taken_out));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(correspondence)
    ->RangeMultiplier(4)
    ->Range(256, 65536)
    ->Unit(benchmark::kMicrosecond)
    ->Complexity(benchmark::oNLogN);

void exhaustive_correspondence(benchmark::State& state) {
  const Contour from = rosette(state.range(0), 5), to = rosette(state.range(0), 12);
  for (auto _ : state) benchmark::DoNotOptimize(plain::best_shift(from, to, Rotation::taken_out));
}
BENCHMARK(exhaustive_correspondence)->Arg(4096)->Unit(benchmark::kMicrosecond);

void crossings(benchmark::State& state) {
  const Contour contour = rosette(state.range(0), 12);
  for (auto _ : state) benchmark::DoNotOptimize(count_crossings(contour));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(crossings)
    ->RangeMultiplier(4)
    ->Range(256, 65536)
    ->Unit(benchmark::kMicrosecond)
    ->Complexity(benchmark::oNLogN);

void plain_crossings(benchmark::State& state) {
  const Contour contour = rosette(state.range(0), 12);
  for (auto _ : state) benchmark::DoNotOptimize(plain::count_crossings(contour));
}
BENCHMARK(plain_crossings)->Arg(1024)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace wavecurve
