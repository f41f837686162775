#include <cmath>

#include "wavecurve/dynamics/schulz_inverse.hpp"
#include "wavecurve/dynamics/shifted_solver.hpp"
#include "wavecurve/dynamics/solver.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

#include "kernel.hpp"
#include "test_problem.hpp"

namespace wavecurve::tracking {

namespace {

std::function<void()> solve(const std::string& solver, double accuracy, Eigen::Index samples,
                            Eigen::Index frames, const Material& material = {}) {
  return [problem = ellipse(samples, frames, material),
          solver = find_solver(solver).make(accuracy)] { solver(problem); };
}

std::function<void()> gradients(Eigen::Index samples) {
  const LagrangeSystem system(find_filter_bank<double>("db4"), samples, all_levels(samples), {});
  Eigen::VectorXd b(samples);
  for (Eigen::Index i = 0; i < samples; ++i) b[i] = std::sin(static_cast<double>(i * i % 9973));
  return [a = std::make_shared<SystemOperator>(system, 1, 1), b, x = b]() mutable {
    x.setZero();
    conjugate_gradients(*a, b, x, 1e-8, true);
  };
}

std::function<void()> schulz(Eigen::Index samples) {
  const Eigen::MatrixXd c =
      damping(find_filter_bank<double>("db4"), samples, all_levels(samples), 1, 1e-4);
  return [c] { schulz_inverse(c, 1e-9); };
}

}  // namespace

std::vector<Kernel> dynamics_kernels() {
  constexpr Eigen::Index frames = 4;
  Kernel spectral{"spectral_solver", 1024,
                  [](Eigen::Index n) { return solve("spectral", 1e-9, n, frames); }};
  spectral.growth = Kernel::Growth::linearithmic;
  spectral.sizes = {256, 1024, 4096, 16384};
  // A complex transform of N points takes 5 N log2 N: x and y together are one; there and back.
  spectral.operations = (1 + frames) * 5.0 * 1024 * 10;
  spectral.bytes = (1 + frames) * 2.0 * 8 * 1024;
  return {
      spectral,
      {"block_decoupled_solver", 1024,
       [](Eigen::Index n) { return solve("block-decoupled", 1e-9, n, frames); }},
      {"coupled_solver", 64, [](Eigen::Index n) { return solve("coupled", 1e-6, n, 2); }},
      {"implicit_solver", 64,
       [](Eigen::Index n) {
         return solve("implicit", 1e-2, n, 2, {1, 1, 0, 0.5, 1e-3, 0});
       }},
      {"conjugate_gradients", 1024, gradients},
      {"schulz_inverse", 32, schulz},
  };
}

}  // namespace wavecurve::tracking
