// Certified numbers from nothing: what the suite spends its time on. All are bound by arithmetic,
// the big-number products inside FLINT; none touches more memory than the caches hold.
#include <benchmark/benchmark.h>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/integrals/product_integrals.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/integrals/product_integrals.hpp"

namespace {

using namespace wavecurve::certified;

constexpr int printed_decimals = 12;
constexpr long bits_of_50_digits = 170;

/// Every alpha-independent number of Table 2: the filter K2, mu and nu, rounded to 12 decimals.
void certified_table_2(benchmark::State& state) {
  for (auto _ : state) {
    const auto c = connection_coefficients(find_filter("K2"), 1, 1, 64);
    const WorkingPrecision precision(128);
    for (int l = 0; l <= c.mu.last_index(); ++l) {
      benchmark::DoNotOptimize(round_to_decimals(c.mu[l] / c.mu[0], printed_decimals));
      benchmark::DoNotOptimize(round_to_decimals(c.nu[l] / c.nu[0], printed_decimals));
    }
  }
}
BENCHMARK(certified_table_2)->Unit(benchmark::kMillisecond);

/// mu of a Daubechies filter to 50 digits; the argument is its order.
void daubechies_mu_50_digits(benchmark::State& state) {
  const std::string name = "db" + std::to_string(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(connection_coefficients(find_filter(name), 1, 1, bits_of_50_digits));
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(daubechies_mu_50_digits)
    ->Unit(benchmark::kMillisecond)
    ->Arg(5)
    ->Arg(10)
    ->Arg(19)
    ->Arg(38)
    ->Complexity();

void orders(benchmark::internal::Benchmark* of_daubechies) {
  for (const int order : {3, 4, 6, 8, 10}) of_daubechies->Arg(order);
  of_daubechies->Unit(benchmark::kMillisecond)->Complexity();
}

wavecurve::ProductIntegral three_scaling_functions() { return {{{{}, false}, {{}}, {{}}}}; }

/// int phi(x) phi(x - l) phi(x - m) dx of a Daubechies filter to 40 digits; the argument is its order.
void three_terms_40_digits(benchmark::State& state) {
  const std::string name = "db" + std::to_string(state.range(0));
  constexpr long bits_of_40_digits = 136;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        product_integrals(find_filter(name), three_scaling_functions(), bits_of_40_digits));
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(three_terms_40_digits)->Apply(orders);

/// The same in double precision.
void three_terms(benchmark::State& state) {
  const auto bank = wavecurve::find_filter_bank("db" + std::to_string(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(wavecurve::product_integrals(bank, three_scaling_functions()));
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(three_terms)->Apply(orders);

/// The same as exact fractions.
void daubechies_mu_exact(benchmark::State& state) {
  const auto definition = find_filter("db" + std::to_string(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(exact_connection_coefficients(definition, 1, 1));
}
BENCHMARK(daubechies_mu_exact)->Unit(benchmark::kMillisecond)->Arg(4)->Arg(10)->Arg(38);

/// A whole filter bank to 50 digits.
void filter_bank_50_digits(benchmark::State& state, const char* name) {
  for (auto _ : state) benchmark::DoNotOptimize(find_filter(name).bank(bits_of_50_digits));
}
BENCHMARK_CAPTURE(filter_bank_50_digits, db4, "db4")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(filter_bank_50_digits, db38, "db38")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(filter_bank_50_digits, sym20, "sym20")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(filter_bank_50_digits, coif5, "coif5")->Unit(benchmark::kMillisecond);

}  // namespace
