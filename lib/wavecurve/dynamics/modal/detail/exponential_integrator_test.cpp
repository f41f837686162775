#include "wavecurve/dynamics/modal/detail/exponential_integrator.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/dynamics/modal/decoupled.hpp"
#include "wavecurve/dynamics/modal/oscillator.hpp"
#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/dynamics/problem_test.hpp"

namespace wavecurve::dynamics {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The responses to powers of time by the series of the solution, in long double, for |r| h of
/// order 1 at most: y'' = (f - c y' - k y) / rho gives the coefficients of y one by one.
std::array<double, 2> series_response(const Oscillator& o, double h, int power) {
  long double last = 0, before = 0, q = 0, v = 0, factorial = 1;
  for (int j = 1; j <= power; ++j) factorial *= j;
  // a_{n+2} (n + 1) (n + 2) = (f_n - c (n + 1) a_{n+1} - k a_n) / rho in powers of t / h.
  const long double c = static_cast<long double>(o.c) * h / o.rho;
  const long double k = static_cast<long double>(o.k) * h * h / o.rho;
  for (int n = 0; n < 200; ++n) {
    const long double f = n == power ? static_cast<long double>(h) * h / o.rho / factorial : 0;
    const long double next = (f - c * (n + 1) * last - k * before) / ((n + 1.0L) * (n + 2.0L));
    q += next;
    v += (n + 2) * next / h;
    before = last;
    last = next;
  }
  return {static_cast<double>(q), static_cast<double>(v)};
}

TEST(RampResponse, IsTheSeriesAcrossAllKindsOfDamping) {
  for (const double k : {0.0, 1e-8, 0.3, 1.0, 4.0, 30.0}) {
    for (const double c : {0.0, 1e-6, 0.5, 1.0, 2.0, 2.000001, 4.0, 10.9, 11.0, 16.0}) {
      for (const double h : {0.01, 0.7, 1.0, 1.3}) {
        const Oscillator oscillator = {1.5, c, k};
        const RampResponse response = ramp_response(oscillator, h);
        for (int power = 0; power < 3; ++power) {
          const auto at = static_cast<std::size_t>(power);
          const auto [q, v] = series_response(oscillator, h, power);
          // Quotients by |r| h of order 1, three in a row: some tens of units of h^2 / rho.
          EXPECT_NEAR(response.q[at], q, 100 * epsilon * h * h / 1.5) << c << " " << k << " " << h;
          EXPECT_NEAR(response.v[at], v, 100 * epsilon * h / 1.5) << c << " " << k << " " << h;
        }
      }
    }
  }
}

/// A linear spring f = -a u is a shift of the stiffness by a G: the same as bringing in K's place
/// the exact solution of another system, here by the symbols of mode 1.
InitialValueProblem spring_problem(const std::string& filter, double a) {
  InitialValueProblem problem = smooth_problem(
      filter, 32,
      {.density = 1.2, .stiffness = 0.5, .mass_damping = 0.1, .stiffness_damping = 1e-3});
  problem.force.general.push_back(
      [a](double, const Eigen::Ref<const Eigen::MatrixXd>& u, const auto&) { return -a * u; });
  problem.initial_displacement.col(0) = problem.initial_displacement.col(1);
  return problem;
}

TEST(ExponentialIntegrator, SolvesALinearSpringAsAStifferCurve) {
  for (const std::string filter : {"db4", "bspline4.4"}) {
    const InitialValueProblem problem = spring_problem(filter, 20);
    const CirculantEigenvalues s = problem.system.eigenvalues();
    for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
      const Trajectory solution = solve_spectral(problem, tolerance);
      for (std::size_t i = 0; i < 5; ++i) {
        const Propagator p = propagator({s.mass[1], s.damping[1], s.stiffness[1] + 20 * s.gram[1]},
                                        problem.times[static_cast<Eigen::Index>(i)]);
        const double scale = problem.initial_displacement.norm();
        EXPECT_LT((solution.displacement[i] - p.qq * problem.initial_displacement).norm(),
                  100 * tolerance * scale);
        EXPECT_LT((solution.velocity[i] - p.vq * problem.initial_displacement).norm(),
                  1000 * tolerance * scale);
      }
    }
  }
}

TEST(ExponentialIntegrator, HasOrderFour) {
  // Errors of steps of order 5 at a tolerance: evaluations grow with tolerance^(-1/5).
  const InitialValueProblem problem = spring_problem("db4", 50);
  const auto coarse = solve_spectral(problem, 1e-7).cost.evaluations;
  const auto fine = solve_spectral(problem, 1e-7 / std::pow(2, 20)).cost.evaluations;
  EXPECT_NEAR(std::log2(static_cast<double>(fine) / static_cast<double>(coarse)) / 20, 0.2, 0.05);
}

TEST(ExponentialIntegrator, IsDuhamelsIntegralForAFunctionOfTime) {
  // cos(3 t) as a function, against the closed form of the harmonic force; of all three models.
  for (const auto solve : {solve_spectral, solve_decoupled, solve_block_decoupled}) {
    InitialValueProblem problem =
        smooth_problem("bspline4.4", 32, {.mass_damping = 0.2, .stiffness_damping = 1e-3});
    const Eigen::MatrixXd samples = smooth_samples(32, 3);
    problem.force.harmonic.push_back({.omega = 3,
                                      .cosine = coefficients_of(problem.system, samples),
                                      .sine = 0 * problem.initial_displacement});
    const Trajectory exact = solve(problem, 1e-9);
    problem.force.harmonic.clear();
    problem.force.general.push_back([samples](double t, const auto&, const auto&) {
      return Eigen::MatrixXd(std::cos(3 * t) * samples);
    });
    const Trajectory integrated = solve(problem, 1e-10);
    EXPECT_LT(largest_difference(integrated.displacement, exact.displacement), 1e-8);
    EXPECT_LT(largest_difference(integrated.velocity, exact.velocity), 1e-7);
  }
}

TEST(ExponentialIntegrator, SolvesTheMasslessEquationToo) {
  InitialValueProblem problem = smooth_problem(
      "db4", 32, {.density = 0, .stiffness = 0.5, .stiffness_damping = 0.01, .damping_density = 1});
  problem.initial_displacement.col(0) = problem.initial_displacement.col(1);
  problem.force.general.push_back(
      [](double, const Eigen::Ref<const Eigen::MatrixXd>& u, const auto&) { return -2 * u; });
  const CirculantEigenvalues s = problem.system.eigenvalues();
  const double rate = -(s.stiffness[1] + 2 * s.gram[1]) / s.damping[1];
  const Trajectory solution = solve_spectral(problem, 1e-9);
  EXPECT_LT((solution.displacement[4] - std::exp(rate) * problem.initial_displacement).norm(),
            1e-7);
  EXPECT_LT((solution.velocity[4] - rate * std::exp(rate) * problem.initial_displacement).norm(),
            1e-5);
}

TEST(ExponentialIntegrator, KeepsTheEnergyInAnAttractingForce) {
  // The potential of the attraction is -strength / sqrt(d^2 + softening^2), of every sample.
  InitialValueProblem problem = smooth_problem("db4", 64, {.stiffness = 0.05});
  problem.rest = uniform_density(problem.system, Eigen::RowVector2d(1, 0));
  problem.initial_velocity = uniform_density(problem.system, Eigen::RowVector2d(0, 0.5));
  problem.force.general.push_back(attraction(Eigen::RowVector2d(0, 0), 0.5, 0.3));
  const Trajectory solution = solve_spectral(problem, 1e-10);
  const Eigen::SparseMatrix<double> k = problem.system.stiffness();
  const PeriodicTransform<double> transform(problem.system.bank(), 64, 6);
  Eigen::VectorXd workspace(transform.workspace_size());
  const auto energy = [&](std::size_t i) {
    const Eigen::MatrixXd& q = solution.displacement[i];
    Eigen::MatrixXd positions(64, 2);
    for (int j = 0; j < 2; ++j) {
      transform.inverse(q.col(j) + problem.rest.col(j), positions.col(j), workspace);
    }
    const Eigen::ArrayXd square = positions.rowwise().squaredNorm().array() + 0.09;
    return 0.5 * solution.velocity[i].squaredNorm() + 0.5 * (q.transpose() * k * q).trace() -
           0.5 * square.rsqrt().sum();
  };
  for (std::size_t i = 1; i < 5; ++i) EXPECT_NEAR(energy(i), energy(0), 1e-7 * std::abs(energy(0)));
}

}  // namespace
}  // namespace wavecurve::dynamics
