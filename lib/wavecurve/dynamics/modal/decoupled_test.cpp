#include "wavecurve/dynamics/modal/decoupled.hpp"

#include <limits>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "wavecurve/dynamics/modal/oscillator.hpp"
#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/dynamics/problem_test.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/transform/bands.hpp"

namespace wavecurve::dynamics {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A matrix without what couples different blocks: those between the borders of the bands, or all
/// of size 1.
Eigen::MatrixXd kept(const Eigen::SparseMatrix<double>& matrix, const LagrangeSystem& system,
                     bool blocks) {
  const Eigen::MatrixXd whole = matrix;
  if (!blocks) return whole.diagonal().asDiagonal();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(whole.rows(), whole.cols());
  for (const Band& band : multiscale_bands(system.samples(), system.levels())) {
    result.block(band.offset, band.offset, band.size, band.size) =
        whole.block(band.offset, band.offset, band.size, band.size);
  }
  return result;
}

/// The plain twin: what is kept of M and K, with C = s_1 M + s_2 K, by the dense generalised
/// eigenproblem.
Eigen::MatrixXd dense_solution(const InitialValueProblem& problem, bool blocks, double t) {
  const LagrangeSystem& system = problem.system;
  const Eigen::MatrixXd mass = kept(system.mass(), system, blocks);
  const Eigen::MatrixXd stiffness = kept(system.stiffness(), system, blocks);
  const Eigen::MatrixXd gram =
      kept(wavecurve::gram(system.bank(), system.samples(), system.levels()), system, blocks);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(stiffness, mass);
  const Eigen::MatrixXd& v = eigen.eigenvectors();  // V^T M V = I
  const Eigen::MatrixXd start = v.transpose() * mass * problem.initial_displacement;
  const Eigen::MatrixXd force = v.transpose() * gram * problem.force.constant;
  Eigen::MatrixXd modes = start;
  const Material& m = system.material();
  for (Eigen::Index n = 0; n < modes.rows(); ++n) {
    const double k = std::max(0.0, eigen.eigenvalues()[n]);
    const Propagator p = propagator({1, m.mass_damping + m.stiffness_damping * k, k}, t);
    modes.row(n) = p.qq * start.row(n) + p.qf * force.row(n);
  }
  return v * modes;
}

TEST(Decoupled, IsTheSystemWithoutItsOffDiagonals) {
  for (const std::string filter : {"db4", "coif2", "bspline4.4", "cdf9.7"}) {
    for (const int levels : {0, 2, 5}) {
      InitialValueProblem problem = smooth_problem(filter, 32, {});
      problem.system = LagrangeSystem(
          problem.system.bank(), 32, levels,
          {.density = 2, .stiffness = 0.7, .mass_damping = 0.3, .stiffness_damping = 1e-3});
      problem.initial_displacement = Eigen::MatrixXd::Random(32, 2);
      problem.force.constant = Eigen::MatrixXd::Random(32, 2);
      const Trajectory diagonal = solve_decoupled(problem);
      const Trajectory blocks = solve_block_decoupled(problem);
      for (std::size_t i = 0; i < 5; ++i) {
        const double t = problem.times[static_cast<Eigen::Index>(i)];
        // The eigenvalues, up to 1e4, are as exact as the largest: 1e4 units, of a phase sqrt(k) t.
        const double bound = 1e5 * epsilon * problem.initial_displacement.norm();
        EXPECT_LT((diagonal.displacement[i] - dense_solution(problem, false, t)).norm(), bound)
            << filter << levels;
        EXPECT_LT((blocks.displacement[i] - dense_solution(problem, true, t)).norm(), bound)
            << filter << levels;
      }
    }
  }
}

TEST(Decoupled, BlocksAreExactWithoutLevels) {
  InitialValueProblem problem = smooth_problem("db4", 32, {});
  problem.system = LagrangeSystem(problem.system.bank(), 32, 0,
                                  {.mass_damping = 0.1, .stiffness_damping = 1e-3});
  const Trajectory blocks = solve_block_decoupled(problem);
  const Trajectory exact = solve_spectral(problem);
  EXPECT_LT(largest_difference(blocks.displacement, exact.displacement), 1e4 * epsilon);
}

TEST(Decoupled, IsFarFromTheCoupledMotion) {
  // What the publication calls small is not: the error is of the size of the displacement.
  const InitialValueProblem problem = smooth_problem("db4", 64, {});
  const double scale = problem.initial_displacement.norm();
  const Trajectory exact = solve_spectral(problem);
  EXPECT_GT(largest_difference(solve_decoupled(problem).displacement, exact.displacement), scale);
}

}  // namespace
}  // namespace wavecurve::dynamics
