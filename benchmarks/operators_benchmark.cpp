// Stiffness in the multiscale basis: assembly, products, transform and spectrum; D8, all levels.
//
// Asked for: assembly at N = 2^16 in at most 1 s, memory proportional to the non-zeros; matrix-free
// product at N = 2^20 in at most 15 ns a sample. The counters per_sample and per_non_zero are
// seconds; the last lines of a family are the fitted complexity.
//
// Measured on two shared cores of an EPYC at 2.6 GHz, processor time:
// - Assembly: 2.4 ns a non-zero up to N = 2^14, 9 ns at 2^16 (116 ms in all), 12 bytes each. What
// it
//   writes bounds it: at 2^16 it is the first touch of 150 MB of fresh pages. The non-zeros grow
//   like N log N; the time like N^1.07 from 2^10 to 2^14, N^1.4 to 2^16 for the pages' sake.
// - Matrix-free product: 6.4 ns a sample at 2^10, 6.1 ns at 2^20; growth N^0.99. Arithmetic bounds
// it,
//   not memory: the time a sample is the same inside and outside the caches, and the transform of
//   floats, twice as many to a register, takes 0.57 of the time. Two transforms of 16
//   multiplications and additions a sample and 14 of the circulant are 46 of each, 23 two-wide
//   instructions of each, and the processor issues two of each a cycle: 4.4 ns at best without
//   wider registers.
// - The assembled matrix times a vector: 62 to 147 ns a sample, ten to twenty times as much.
#include <benchmark/benchmark.h>

#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/operators/multiscale_operator.hpp"
#include "wavecurve/operators/spectrum.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve {
namespace {

const FilterBank<double>& d8() {
  static const FilterBank<double> bank = find_filter_bank<double>("db4");
  return bank;
}

/// Seconds per item, shown as such with the prefix n.
benchmark::Counter time_per(double items) {
  return {items, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

void assembly(benchmark::State& state) {
  const Eigen::Index samples = state.range(0);
  double non_zeros = 0, bytes = 0;
  for (auto _ : state) {
    const auto k = stiffness(d8(), samples, all_levels(samples));
    benchmark::DoNotOptimize(k.valuePtr());
    non_zeros = static_cast<double>(k.nonZeros());
    bytes = static_cast<double>(k.data().allocatedSize() * (sizeof(double) + sizeof(int)));
  }
  state.SetComplexityN(samples);
  state.counters["non_zeros"] = non_zeros;
  state.counters["bytes_per_non_zero"] = bytes / non_zeros;
  state.counters["per_non_zero"] = time_per(non_zeros);
}

void product(benchmark::State& state) {
  const Eigen::Index samples = state.range(0);
  MultiscaleOperator k(d8(), samples, all_levels(samples));
  const Eigen::VectorXd x = Eigen::VectorXd::Random(samples);
  Eigen::VectorXd y(samples);
  for (auto _ : state) {
    k.apply(x, y);
    benchmark::DoNotOptimize(y.data());
    benchmark::ClobberMemory();
  }
  state.SetComplexityN(samples);
  state.counters["per_sample"] = time_per(static_cast<double>(samples));
}

void assembled_product(benchmark::State& state) {
  const Eigen::Index samples = state.range(0);
  const auto k = stiffness(d8(), samples, all_levels(samples));
  const Eigen::VectorXd x = Eigen::VectorXd::Random(samples);
  Eigen::VectorXd y(samples);
  for (auto _ : state) {
    y.noalias() = k * x;
    benchmark::DoNotOptimize(y.data());
    benchmark::ClobberMemory();
  }
  state.SetComplexityN(samples);
  state.counters["per_sample"] = time_per(static_cast<double>(samples));
}

template <class Scalar>
void inverse_transform(benchmark::State& state) {
  using Vector = Eigen::Vector<Scalar, Eigen::Dynamic>;
  const Eigen::Index samples = state.range(0);
  const PeriodicTransform<Scalar> transform(find_filter_bank<Scalar>("db4"), samples,
                                            all_levels(samples));
  const Vector x = Vector::Random(samples);
  Vector y(samples), workspace(transform.workspace_size());
  for (auto _ : state) {
    transform.inverse(x, y, workspace);
    benchmark::DoNotOptimize(y.data());
    benchmark::ClobberMemory();
  }
  state.SetComplexityN(samples);
  state.counters["per_sample"] = time_per(static_cast<double>(samples));
}

void spectrum(benchmark::State& state) {
  const Eigen::Index samples = state.range(0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(extreme_eigenvalues(d8(), samples, all_levels(samples), 1).largest);
  }
  state.SetComplexityN(samples);
}

BENCHMARK(assembly)
    ->RangeMultiplier(4)
    ->Range(1 << 10, 1 << 16)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);
BENCHMARK(product)->RangeMultiplier(4)->Range(1 << 10, 1 << 20)->Complexity(benchmark::oN);
BENCHMARK(assembled_product)
    ->RangeMultiplier(4)
    ->Range(1 << 10, 1 << 16)
    ->Complexity(benchmark::oNLogN);
BENCHMARK(inverse_transform<double>)
    ->RangeMultiplier(4)
    ->Range(1 << 10, 1 << 20)
    ->Complexity(benchmark::oN);
BENCHMARK(inverse_transform<float>)
    ->RangeMultiplier(4)
    ->Range(1 << 10, 1 << 20)
    ->Complexity(benchmark::oN);
BENCHMARK(spectrum)
    ->RangeMultiplier(4)
    ->Range(1 << 6, 1 << 16)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);

}  // namespace
}  // namespace wavecurve
