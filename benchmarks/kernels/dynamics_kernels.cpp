#include <cmath>
#include <memory>

#include "wavecurve/dynamics/schulz_inverse.hpp"
#include "wavecurve/dynamics/solver.hpp"
#include "wavecurve/dynamics/stepping/detail/shifted_solver.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/transform/bands.hpp"

#include "benchmarks/kernels/kernel.hpp"
#include "benchmarks/kernels/test_problem.hpp"

namespace wavecurve::tracking {

namespace {

std::function<void()> solve(const std::string& solver, double accuracy, Eigen::Index samples,
                            Eigen::Index frames, const dynamics::Material& material = {}) {
  return [problem = ellipse(samples, frames, material),
          solver = dynamics::find_solver(solver).make({.tolerance = accuracy, .step = accuracy})] {
    solver(problem);
  };
}

/// K + G, a right-hand side without structure, and the solution to be.
struct LinearSystem {
  explicit LinearSystem(Eigen::Index samples)
      : a({find_filter_bank<double>("db4"), samples, all_levels(samples), {}}, 1, 1),
        b(samples),
        x(samples) {
    for (Eigen::Index i = 0; i < samples; ++i) b[i] = std::sin(static_cast<double>(i * i % 9973));
  }
  int iterations() {
    x.setZero();
    return dynamics::conjugate_gradients(a, b, x, 1e-8, true);
  }
  dynamics::SystemOperator a;
  Eigen::VectorXd b, x;
};

std::function<void()> gradients(Eigen::Index samples) {
  return [system = std::make_shared<LinearSystem>(samples)] { system->iterations(); };
}

Eigen::MatrixXd damping_matrix(Eigen::Index samples) {
  return damping(find_filter_bank<double>("db4"), samples, all_levels(samples), 1, 1e-4);
}

std::function<void()> schulz(Eigen::Index samples) {
  return [c = damping_matrix(samples)] { dynamics::schulz_inverse(c, 1e-9); };
}

// What an iteration takes depends on how many steps it needs, so each is run once for its limit.

/// Operations a sample: two transforms of 18, the circulant of 7 multiplications and 12 additions, as of
/// operator_product; and six sums of the method, of a product and an addition each.
constexpr double product_operations = 2 * 18 + 7 + 12, sums_operations = 2 * 6;

double gradients_operations(Eigen::Index samples) {
  // One product more, for the residual of the guess.
  return (LinearSystem(samples).iterations() + 1) * (product_operations + sums_operations) *
         static_cast<double>(samples);
}

/// Two matrix products a step, but for the last, of which only the residual is wanted; and C^T C.
double schulz_operations(Eigen::Index samples) {
  const auto steps =
      static_cast<double>(dynamics::schulz_inverse(damping_matrix(samples), 1e-9).residuals.size());
  return 2 * steps * 2 * std::pow(static_cast<double>(samples), 3);
}

/// What the library counts by formula, nearly all of it products with K and the sums of the method;
/// but it takes the transforms for sums of products, more than the rotations need.
double counted_operations(const std::string& solver, const dynamics::InitialValueProblem& problem,
                          double accuracy) {
  const dynamics::Trajectory trajectory =
      dynamics::find_solver(solver).make({.tolerance = accuracy, .step = accuracy})(problem);
  const auto counted =
      static_cast<double>(dynamics::SystemOperator(problem.system, 1, 1).operations()) /
      static_cast<double>(problem.system.samples());
  return static_cast<double>(trajectory.cost.operations) * (product_operations + sums_operations) /
         (counted + sums_operations);
}

/// A complex transform of N points takes 5 N log2 N: x and y together are one.
double fourier_operations(Eigen::Index points) {
  const auto n = static_cast<double>(points);
  return 5 * n * std::log2(n);
}

}  // namespace

std::vector<Kernel> dynamics_kernels() {
  constexpr Eigen::Index frames = 4;
  Kernel spectral{"spectral_solver", 1024,
                  [](Eigen::Index n) { return solve("spectral", 1e-9, n, frames); }};
  spectral.growth = Kernel::Growth::linearithmic;
  spectral.sizes = {256, 1024, 4096, 16384};
  // The start and each frame: a Fourier transform, two wavelet transforms of 18 a sample, a real
  // factor each mode. The sines and cosines of the modes are not counted.
  spectral.operations = (1 + frames) * (fourier_operations(1024) + (2 * 18 + 2) * 1024.0);
  spectral.bytes = (1 + frames) * 2.0 * 8 * 1024;
  Kernel block{"block_decoupled_solver", 1024,
               [](Eigen::Index n) { return solve("block-decoupled", 1e-9, n, frames); }};
  // The same without wavelet transforms, and with a Fourier transform each band.
  for (const Band& band : multiscale_bands(1024, 10)) {
    block.operations += (1 + frames) * (fourier_operations(band.size) + 2.0 * band.size);
  }
  block.bytes = spectral.bytes;
  Kernel coupled{"coupled_solver", 64, [](Eigen::Index n) { return solve("coupled", 1e-6, n, 2); }};
  static const double of_coupled = counted_operations("coupled", ellipse(64, 2, {}), 1e-6);
  coupled.operations = of_coupled;
  static constexpr dynamics::Material damped{.mass_damping = 0.5, .stiffness_damping = 1e-3};
  Kernel implicit{"implicit_solver", 64,
                  [](Eigen::Index n) { return solve("implicit", 1e-2, n, 2, damped); }};
  static const double of_implicit = counted_operations("implicit", ellipse(64, 2, damped), 1e-2);
  implicit.operations = of_implicit;
  Kernel conjugate{"conjugate_gradients", 1024, gradients};
  static const double of_gradients = gradients_operations(1024);
  conjugate.operations = of_gradients;
  Kernel inverse{"schulz_inverse", 32, schulz};
  static const double of_schulz = schulz_operations(32);
  inverse.operations = of_schulz;
  return {spectral, block, coupled, implicit, conjugate, inverse};
}

}  // namespace wavecurve::tracking
