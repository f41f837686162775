// The periodic transform beside its peers: D8, all levels, processor time a sample (per_sample).
// PyWavelets is measured by peers/transform_pywavelets.py; `wavecurve bench peers` interleaves the
// two.
//
// Asked for, double: at N = 2^14 to 2^16 at most 0.4 ns a sample each way, 8 times faster than
// PyWavelets' compiled core, 12 times faster than GSL; at 2^22 at most 2.5 times memcpy's time.
//
// For 10,000 curves of 256 samples at most 0.6 ns a sample.
//
// Measured on two shared cores of an EPYC (Zen 4, 3.7 GHz at best, other programs beside it), the
// fastest of 15 runs:
// - 0.6 to 0.7 ns a sample at 2^14 to 2^16, not 0.4: 9 to 13 times faster than GSL, 10 times the
//   plain loop. PyWavelets' compiled core, taken at 2^18 where its calls from Python no longer
//   count, took 9.4 ns forward and 5.3 ns inverse, 13 and 7 times as much.
// - What bounds it: 16 samples are 10 multiplications, 8 additions and 5 shuffles (two to part the
//   pairs, one a delay) of 512 bits, of which each takes two of the four units' slots: at least
//   11.5 cycles, 1.44 a sample for all levels, 0.39 ns. The loop alone, in the first-level cache,
//   takes 16.2 cycles; with four vectors passing each rotation together 14.9, 0.51 ns. Without the
//   shuffles it would take 10.7, without the scale of c one less; alignment makes no difference.
//   Fused operations, which would let results depend on the machine, would not lessen the shuffles.
// - 2.2 ns at 2^22 on a quiet machine, 2.1 times memcpy (beside other programs 5.5 to 6, memcpy 1.6
//   to 4.4; level by level 7.6 to 8.2 then). memcpy does not read its target, three levels at once
//   read and write 3/2 as much.
// - Batches: 0.9 ns a sample where they fit the caches (8 to 1,000 curves), not 0.6: one lane a
//   signal needs no shuffles, 0.37 ns for the loop, but 0.25 to interleave and to separate the
//   columns and 0.25 to start eight levels. 10,000 curves are 20 MB in and 20 MB out: 1.9 to 2.2,
//   memcpy of the same 0.8; prefetching the next group made no difference.
// - 2.0 to 2.6 ns a sample of a single curve at 2^8: the start and the wrap of each of eight
//   levels.
// - cdf9.7 takes 1.2 ns, by sums of products: both outputs of a pair from one load of the inputs.
//   Each from its own loads, and zeros of the shorter filter included, took 1.5.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#ifdef WAVECURVE_GSL
#include <gsl/gsl_errno.h>
#include <gsl/gsl_wavelet.h>
#endif

#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/filters/filter_tables.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve {
namespace {

const FilterBank<double>& d8() {
  static const FilterBank<double> bank = find_filter_bank<double>("db4");
  return bank;
}

/// Seconds a sample; processor time, since the machine may be shared.
void count_samples(benchmark::State& state, Eigen::Index samples) {
  state.counters["per_sample"] = {
      static_cast<double>(samples),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

enum class Direction { forward, inverse };

template <class Scalar, Direction direction>
void single(benchmark::State& state, const char* family) {
  using Vector = Eigen::Vector<Scalar, Eigen::Dynamic>;
  const Eigen::Index samples = state.range(0);
  const PeriodicTransform<Scalar> dpwt(find_filter_bank<Scalar>(family), samples,
                                       all_levels(samples));
  const Vector x = Vector::Random(samples);
  Vector y(samples), workspace(dpwt.workspace_size());
  for (auto _ : state) {
    if (direction == Direction::forward) dpwt.forward(x, y, workspace);
    if (direction == Direction::inverse) dpwt.inverse(x, y, workspace);
    benchmark::DoNotOptimize(y.data());
    benchmark::ClobberMemory();
  }
  count_samples(state, samples);
}

/// Many curves at once: 10,000 signals of 256 samples, a column each.
template <class Scalar, Direction direction>
void batch(benchmark::State& state, const char* family) {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::Index samples = 256, columns = state.range(0);
  const PeriodicTransform<Scalar> dpwt(find_filter_bank<Scalar>(family), samples,
                                       all_levels(samples));
  const Matrix x = Matrix::Random(samples, columns);
  Matrix y = x;
  Eigen::Vector<Scalar, Eigen::Dynamic> workspace(dpwt.workspace_size(columns));
  for (auto _ : state) {
    if (direction == Direction::forward) dpwt.forward(x, y, workspace);
    if (direction == Direction::inverse) dpwt.inverse(x, y, workspace);
    benchmark::DoNotOptimize(y.data());
    benchmark::ClobberMemory();
  }
  count_samples(state, samples * columns);
}

/// (2.8) as one would write it: a loop over outputs and taps, indices by remainder only at the end.
void plain_loop(benchmark::State& state) {
  const Eigen::Index samples = state.range(0);
  const std::vector<double>&h = d8().analysis_low.taps, &g = d8().analysis_high.taps;
  const Eigen::Index g_first = d8().analysis_high.first_index;
  Eigen::VectorXd x = Eigen::VectorXd::Random(samples), y(samples), c(samples);
  for (auto _ : state) {
    c = x;
    for (Eigen::Index size = samples; size > 1; size /= 2) {
      for (Eigen::Index n = 0; n < size / 2; ++n) {
        double low = 0, high = 0;
        for (Eigen::Index k = 0; k < 8; ++k) {
          low += h[static_cast<std::size_t>(k)] * c[(2 * n + k) & (size - 1)];
          high += g[static_cast<std::size_t>(k)] * c[(2 * n + k + g_first) & (size - 1)];
        }
        y[n] = low;
        y[size / 2 + n] = high;
      }
      c.head(size / 2) = y.head(size / 2);
    }
    benchmark::DoNotOptimize(y.data());
    benchmark::ClobberMemory();
  }
  count_samples(state, samples);
}

#ifdef WAVECURVE_GSL
template <Direction direction>
void gsl(benchmark::State& state) {
  const Eigen::Index samples = state.range(0);
  const auto size = static_cast<std::size_t>(samples);
  gsl_wavelet* wavelet = gsl_wavelet_alloc(gsl_wavelet_daubechies, 8);
  gsl_wavelet_workspace* workspace = gsl_wavelet_workspace_alloc(size);
  // In place: alternate with a copy, so that values stay bounded; the copy is a few per cent.
  const Eigen::VectorXd x = Eigen::VectorXd::Random(samples);
  Eigen::VectorXd y(samples);
  for (auto _ : state) {
    y = x;
    const bool forward = direction == Direction::forward;
    gsl_wavelet_transform(wavelet, y.data(), 1, size,
                          forward ? gsl_wavelet_forward : gsl_wavelet_backward, workspace);
    benchmark::DoNotOptimize(y.data());
    benchmark::ClobberMemory();
  }
  count_samples(state, samples);
  gsl_wavelet_workspace_free(workspace);
  gsl_wavelet_free(wavelet);
}
BENCHMARK(gsl<Direction::forward>)->RangeMultiplier(4)->Range(1 << 8, 1 << 22);
BENCHMARK(gsl<Direction::inverse>)->RangeMultiplier(4)->Range(1 << 8, 1 << 22);
#endif

void copy(benchmark::State& state) {
  const Eigen::Index samples = state.range(0);
  const Eigen::VectorXd x = Eigen::VectorXd::Random(samples);
  Eigen::VectorXd y(samples);
  for (auto _ : state) {
    std::memcpy(y.data(), x.data(), static_cast<std::size_t>(samples) * sizeof(double));
    benchmark::DoNotOptimize(y.data());
    benchmark::ClobberMemory();
  }
  count_samples(state, samples);
}

void sizes(benchmark::internal::Benchmark* b) {
  for (int exponent : {8, 10, 12, 14, 16, 18, 20, 22}) b->Arg(1 << exponent);
}

void columns(benchmark::internal::Benchmark* b) { b->Arg(2)->Arg(8)->Arg(10000); }

/// SCALAR/FAMILY/single/SAMPLES and SCALAR/FAMILY/batch/COLUMNS.
template <class Scalar, Direction direction>
void add_transforms(const char* prefix) {
  for (const char* family : {"db4", "cdf9.7", "bspline4.4"}) {
    const std::string name = std::string(prefix) + "/" + family;
    benchmark::RegisterBenchmark((name + "/single").c_str(), single<Scalar, direction>, family)
        ->Apply(sizes);
    benchmark::RegisterBenchmark((name + "/batch").c_str(), batch<Scalar, direction>, family)
        ->Apply(columns);
  }
}
const bool added = [] {
  add_transforms<double, Direction::forward>("double/forward");
  add_transforms<double, Direction::inverse>("double/inverse");
  add_transforms<float, Direction::forward>("float/forward");
  add_transforms<float, Direction::inverse>("float/inverse");
  return true;
}();

BENCHMARK(plain_loop)->Apply(sizes);
BENCHMARK(copy)->Apply(sizes);

/// |inverse(forward(x)) - x| / |x| in units of 2^-52 a level, the largest of several sequences.
template <class RoundTrip>
double units_per_level(Eigen::Index samples, RoundTrip round_trip) {
  double worst = 0;
  for (int i = 0; i < 8; ++i) {
    const Eigen::VectorXd x = Eigen::VectorXd::Random(samples);
    Eigen::VectorXd y = x;
    round_trip(y);
    worst = std::max(worst, (y - x).norm() / x.norm());
  }
  return worst * 0x1p52 / all_levels(samples);
}

#ifdef WAVECURVE_GSL
/// Where GSL has the family: its type and member.
std::pair<const gsl_wavelet_type*, std::size_t> gsl_name(const std::string& name) {
  if (name == "haar" || name == "db1") return {gsl_wavelet_haar, 2};
  std::size_t a = 0, b = 0;
  if (std::sscanf(name.c_str(), "bspline%zu.%zu", &a, &b) == 2) {
    return {gsl_wavelet_bspline, 100 * a + b};
  }
  if (std::sscanf(name.c_str(), "db%zu", &a) == 1) return {gsl_wavelet_daubechies, 2 * a};
  return {nullptr, 0};
}

/// "-" where GSL does not have the family.
std::string gsl_round_trip(const std::string& family, Eigen::Index samples) {
  gsl_set_error_handler_off();
  const auto [type, member] = gsl_name(family);
  gsl_wavelet* wavelet = type ? gsl_wavelet_alloc(type, member) : nullptr;
  if (!wavelet) return "-";
  const auto size = static_cast<std::size_t>(samples);
  gsl_wavelet_workspace* workspace = gsl_wavelet_workspace_alloc(size);
  const double units = units_per_level(samples, [&](Eigen::VectorXd& x) {
    gsl_wavelet_transform_forward(wavelet, x.data(), 1, size, workspace);
    gsl_wavelet_transform_inverse(wavelet, x.data(), 1, size, workspace);
  });
  gsl_wavelet_workspace_free(workspace);
  gsl_wavelet_free(wavelet);
  return fmt::format("{:.2g}", units);
}
#else
std::string gsl_round_trip(const std::string&, Eigen::Index) { return "-"; }
#endif

/// The round trip of every family, 256 samples, all levels; "-" where GSL does not have it.
/// peers/transform_pywavelets.py prints the same for PyWavelets.
void print_round_trips() {
  constexpr Eigen::Index samples = 256;
  fmt::print("round trip, units of 2^-52 a level\n{:12} {:>10} {:>10}\n", "family", "wavecurve",
             "GSL");
  std::vector<std::string> families{"bspline2.2", "bspline2.4", "bspline2.6", "bspline2.8",
                                    "bspline3.1", "bspline3.3", "bspline3.5", "bspline3.7",
                                    "bspline3.9", "bspline4.4"};
  for (const FilterTableRow& row : filter_table_rows()) families.emplace_back(row.name);
  for (const std::string& family : families) {
    const PeriodicTransform<double> dpwt(find_filter_bank<double>(family), samples,
                                         all_levels(samples));
    Eigen::VectorXd workspace(dpwt.workspace_size());
    const double own = units_per_level(samples, [&](Eigen::VectorXd& x) {
      dpwt.forward(x, x, workspace);
      dpwt.inverse(x, x, workspace);
    });
    fmt::print("{:12} {:10.2g} {:>10}\n", family, own, gsl_round_trip(family, samples));
  }
}

}  // namespace
}  // namespace wavecurve

int main(int argc, char** argv) {
  if (argc == 1) wavecurve::print_round_trips();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
