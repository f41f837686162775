#include "benchmarks/kernels/limits.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <limits>
#include <vector>

#include <benchmark/benchmark.h>

#include "wavecurve/elementary/detail/highway_targets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "benchmarks/kernels/limits.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace wavecurve::tracking::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The doubles that were added and multiplied. Eight independent chains of each keep both units of
/// a processor with a latency of four cycles busy; from different starts, or the compiler would see
/// that they are one.
double work(long rounds, double* sink) {
  const hn::ScalableTag<double> d;
  constexpr int chains = 8;
  hn::Vec<decltype(d)> sum[chains], product[chains];
  for (int i = 0; i < chains; ++i) sum[i] = product[i] = hn::Set(d, 1 + i);
  const auto step = hn::Set(d, 1e-9), factor = hn::Set(d, 1 - 1e-9);
  for (long round = 0; round < rounds; ++round) {
    for (int i = 0; i < chains; ++i) {
      sum[i] = hn::Add(sum[i], step);
      product[i] = hn::Mul(product[i], factor);
    }
  }
  auto total = hn::Zero(d);
  for (int i = 0; i < chains; ++i) total = hn::Add(total, hn::Add(sum[i], product[i]));
  *sink = hn::GetLane(total);
  return 2.0 * chains * static_cast<double>(hn::Lanes(d)) * static_cast<double>(rounds);
}

}  // namespace wavecurve::tracking::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wavecurve::tracking {

HWY_EXPORT(work);

namespace {

template <class Work>
double seconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

double copy_seconds(double bytes) {
  const auto half = static_cast<std::size_t>(std::max(bytes / 2, 64.0));
  std::vector<char> from(half, 1), to(half, 2);
  // At least 100 microseconds a run, so that the clock does not matter.
  const int copies = static_cast<int>(std::clamp(1e6 / static_cast<double>(half), 1.0, 1e4));
  double best = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 25; ++run) {
    best = std::min(best, seconds([&] {
                      for (int i = 0; i < copies; ++i) {
                        std::memcpy(to.data(), from.data(), half);
                        benchmark::DoNotOptimize(to.data());
                        benchmark::ClobberMemory();
                      }
                    }));
  }
  return best / copies;
}

double arithmetic_peak() {
  double best = 0, sink = 0;
  for (int run = 0; run < 25; ++run) {
    double operations = 0;
    const double time = seconds([&] { operations = HWY_DYNAMIC_DISPATCH(work)(100000, &sink); });
    benchmark::DoNotOptimize(sink);
    best = std::max(best, operations / time);
  }
  return best;
}

}  // namespace wavecurve::tracking
#endif
