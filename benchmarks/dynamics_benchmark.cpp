// The dynamics solvers side by side, section by section; --benchmark_filter picks one. Peers:
// SUNDIALS' CVODE and ARKODE with the same operator, where they are installed, and Eigen's LDLT.
#include <cmath>
#include <string>

#include <Eigen/Cholesky>
#include <benchmark/benchmark.h>

#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/dynamics/schulz_inverse.hpp"
#include "wavecurve/dynamics/solver.hpp"
#include "wavecurve/dynamics/stepping/coupled.hpp"
#include "wavecurve/dynamics/stepping/detail/equation_of_motion.hpp"
#include "wavecurve/dynamics/stepping/detail/shifted_solver.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/transform/fourier_transform.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

#include "benchmarks/kernels/test_problem.hpp"

namespace wavecurve {
namespace {

using tracking::ellipse;

double error_of(const dynamics::Trajectory& solution, const dynamics::Trajectory& exact) {
  return (solution.displacement.back() - exact.displacement.back()).norm() /
         exact.displacement.front().norm();
}

/// A solver by name; the counters say how exact it was and what it did.
void solve(benchmark::State& state, const std::string& name, double accuracy,
           dynamics::Material material) {
  const dynamics::InitialValueProblem problem = ellipse(state.range(0), 60, material);
  const dynamics::Solver solver =
      dynamics::find_solver(name).make({.tolerance = accuracy, .step = accuracy});
  dynamics::Trajectory solution;
  for (auto _ : state) benchmark::DoNotOptimize(solution = solver(problem));
  state.counters["error"] = error_of(solution, dynamics::solve_spectral(problem));
  state.counters["evaluations"] = static_cast<double>(solution.cost.evaluations);
  state.SetComplexityN(state.range(0));
}

void one_frame(benchmark::State& state) {
  const dynamics::InitialValueProblem problem = ellipse(state.range(0), 1);
  for (auto _ : state) benchmark::DoNotOptimize(dynamics::solve_spectral(problem));
}

/// As the peers are asked: the state at t = 1 alone.
void solve_end(benchmark::State& state, const std::string& name, double accuracy) {
  const dynamics::InitialValueProblem problem = ellipse(state.range(0), 1);
  const dynamics::Solver solver =
      dynamics::find_solver(name).make({.tolerance = accuracy, .step = accuracy});
  dynamics::Trajectory solution;
  for (auto _ : state) benchmark::DoNotOptimize(solution = solver(problem));
  const Eigen::MatrixXd exact = dynamics::solve_spectral(problem).displacement[0];
  state.counters["error"] =
      (solution.displacement[0] - exact).norm() / problem.initial_displacement.norm();
  state.counters["evaluations"] = static_cast<double>(solution.cost.evaluations);
}

void conjugate_gradients_iterations(benchmark::State& state, bool is_preconditioned) {
  const Eigen::Index samples = state.range(0);
  const dynamics::LagrangeSystem system(find_filter_bank<double>("db4"), samples,
                                        all_levels(samples), {});
  dynamics::SystemOperator a(system, 1, 1);
  Eigen::VectorXd b(samples), x(samples);
  for (Eigen::Index i = 0; i < samples; ++i) {
    b[i] = std::sin(1e4 * static_cast<double>(i * i % 9973));
  }
  int iterations = 0;
  for (auto _ : state) {
    x.setZero();
    iterations = dynamics::conjugate_gradients(a, b, x, 1e-8, is_preconditioned);
  }
  state.counters["iterations"] = iterations;
}

/// M + 1e-4 K, well conditioned and with a sparse inverse up to a few hundred samples only.
Eigen::SparseMatrix<double> damping_matrix(Eigen::Index samples) {
  return damping(find_filter_bank<double>("db4"), samples, all_levels(samples), 1, 1e-4);
}

void schulz_dense(benchmark::State& state) {
  const Eigen::MatrixXd c = damping_matrix(state.range(0));
  std::size_t steps = 0;
  for (auto _ : state) steps = dynamics::schulz_inverse(c, 1e-9).residuals.size();
  state.counters["steps"] = static_cast<double>(steps);
}

void schulz_sparse(benchmark::State& state) {
  const Eigen::SparseMatrix<double> c = damping_matrix(state.range(0));
  dynamics::SchulzInverse<Eigen::SparseMatrix<double>> result;
  for (auto _ : state) result = dynamics::schulz_inverse(c, 1e-9, 1e-12);
  state.counters["steps"] = static_cast<double>(result.residuals.size());
  state.counters["residual"] = result.residuals.back();
  state.counters["filled"] =
      static_cast<double>(result.inverse.nonZeros()) / static_cast<double>(c.rows() * c.cols());
}

void ldlt_inverse(benchmark::State& state) {
  const Eigen::MatrixXd c = damping_matrix(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        Eigen::MatrixXd(c.ldlt().solve(Eigen::MatrixXd::Identity(c.rows(), c.cols()))));
  }
}

/// C^-1 b by the Fourier transform: there is no need of the inverse.
void fourier_solve(benchmark::State& state) {
  const Eigen::Index samples = state.range(0);
  const dynamics::LagrangeSystem system(find_filter_bank<double>("db4"), samples,
                                        all_levels(samples),
                                        {.mass_damping = 1, .stiffness_damping = 1e-4});
  const std::unique_ptr<dynamics::ModalBasis> basis = dynamics::fourier_basis(system);
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(samples, 2);
  for (auto _ : state) {
    dynamics::ModalCoefficients spectrum = basis->forward(b);
    for (Eigen::Index k = 0; k < samples; ++k) {
      spectrum.row(k) /= basis->modes().damping[basis->mode(k)];
    }
    benchmark::DoNotOptimize(basis->backward(std::move(spectrum), 2));
  }
}

/// The least of several runs, for other programs only ever add to a time.
double least(const std::vector<double>& times) {
  return *std::min_element(times.begin(), times.end());
}

const dynamics::Material undamped = {}, damped = {.mass_damping = 0.5, .stiffness_damping = 1e-3};

// 60 frames of N = 1024, and one of 2^20.
BENCHMARK_CAPTURE(solve, spectral, "spectral", 1e-9, undamped)
    ->RangeMultiplier(4)
    ->Range(64, 1 << 16)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(one_frame)
    ->Arg(1 << 20)
    ->Repetitions(9)
    ->ComputeStatistics("least", least)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, spectral_60_frames, "spectral", 1e-9, undamped)
    ->Arg(1024)
    ->Repetitions(9)
    ->ComputeStatistics("least", least)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, decoupled, "decoupled", 1e-9, undamped)
    ->RangeMultiplier(4)
    ->Range(64, 1 << 14)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, block_decoupled, "block-decoupled", 1e-9, undamped)
    ->RangeMultiplier(4)
    ->Range(64, 1 << 14)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, coupled, "coupled", 1e-6, undamped)
    ->RangeMultiplier(4)
    ->Range(64, 1024)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, coupled_cash_karp, "coupled-cash-karp", 1e-6, undamped)
    ->RangeMultiplier(4)
    ->Range(64, 1024)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, coupled_dormand_prince, "coupled-dormand-prince", 1e-6, undamped)
    ->RangeMultiplier(4)
    ->Range(64, 1024)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, coupled_dense, "coupled-dense", 1e-6, undamped)
    ->RangeMultiplier(4)
    ->Range(64, 1024)
    ->Complexity()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(solve, implicit, "implicit", 1e-3, damped)
    ->RangeMultiplier(4)
    ->Range(64, 1024)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, implicit_rosenbrock, "implicit-rosenbrock", 1e-5, damped)
    ->RangeMultiplier(4)
    ->Range(64, 1024)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);

// At equal achieved error: compare the counters, and the times of rows whose errors are alike.
BENCHMARK_CAPTURE(solve_end, spectral, "spectral", 1e-9)->Arg(256)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_end, coupled_1e6, "coupled", 1e-6)->Arg(256)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_end, coupled_1e8, "coupled", 1e-8)->Arg(256)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_end, coupled_dense_1e6, "coupled-dense", 1e-6)
    ->Arg(256)
    ->Unit(benchmark::kMillisecond);
// The same by SUNDIALS: peers/dynamics_sundials.cpp.

BENCHMARK_CAPTURE(conjugate_gradients_iterations, diagonal, true)
    ->RangeMultiplier(4)
    ->Range(1 << 8, 1 << 18)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(conjugate_gradients_iterations, none, false)
    ->RangeMultiplier(4)
    ->Range(1 << 8, 1 << 12)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

// Up to the largest size that ends within a minute or two: a product of the dense iteration is
// O(N^3), and it takes 2 log2(condition number) steps and more.
BENCHMARK(schulz_dense)->RangeMultiplier(2)->Range(64, 1024)->Unit(benchmark::kMillisecond);
BENCHMARK(schulz_sparse)->RangeMultiplier(2)->Range(64, 1024)->Unit(benchmark::kMillisecond);
BENCHMARK(schulz_sparse)->Arg(2048)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(ldlt_inverse)->RangeMultiplier(2)->Range(64, 2048)->Unit(benchmark::kMillisecond);
BENCHMARK(ldlt_inverse)->Arg(4096)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(fourier_solve)->RangeMultiplier(2)->Range(64, 4096)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wavecurve
