#include "limits.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <limits>
#include <vector>

#include <benchmark/benchmark.h>

#include "wavecurve/transform/highway_targets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/limits.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace wavecurve::tracking::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The doubles that were added and multiplied. Eight independent chains of each keep both units of
/// a processor with a latency of four cycles busy; each starts elsewhere, since of chains with the
/// same values the compiler computes one.
double work(long rounds, double* sink) {
  const hn::ScalableTag<double> d;
  auto a0 = hn::Set(d, 1), a1 = hn::Set(d, 2), a2 = hn::Set(d, 3), a3 = hn::Set(d, 4);
  auto a4 = hn::Set(d, 5), a5 = hn::Set(d, 6), a6 = hn::Set(d, 7), a7 = hn::Set(d, 8);
  auto m0 = a0, m1 = a1, m2 = a2, m3 = a3, m4 = a4, m5 = a5, m6 = a6, m7 = a7;
  const auto step = hn::Set(d, 1e-9), factor = hn::Set(d, 1 - 1e-9);
  for (long i = 0; i < rounds; ++i) {
    a0 = hn::Add(a0, step), m0 = hn::Mul(m0, factor), a1 = hn::Add(a1, step);
    m1 = hn::Mul(m1, factor), a2 = hn::Add(a2, step), m2 = hn::Mul(m2, factor);
    a3 = hn::Add(a3, step), m3 = hn::Mul(m3, factor), a4 = hn::Add(a4, step);
    m4 = hn::Mul(m4, factor), a5 = hn::Add(a5, step), m5 = hn::Mul(m5, factor);
    a6 = hn::Add(a6, step), m6 = hn::Mul(m6, factor), a7 = hn::Add(a7, step);
    m7 = hn::Mul(m7, factor);
  }
  auto sum = a0;
  for (const auto& v : {a1, a2, a3, a4, a5, a6, a7, m0, m1, m2, m3, m4, m5, m6, m7}) {
    sum = hn::Add(sum, v);
  }
  *sink = hn::GetLane(sum);
  return 16.0 * static_cast<double>(hn::Lanes(d)) * static_cast<double>(rounds);
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
