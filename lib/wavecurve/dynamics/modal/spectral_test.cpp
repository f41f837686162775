#include "wavecurve/dynamics/modal/spectral.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "wavecurve/dynamics/modal/matrix_exponential_test.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve::dynamics {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Eigen::MatrixXd random_state(Eigen::Index samples, Eigen::Index coordinates) {
  Eigen::MatrixXd state(samples, coordinates);
  for (double& value : state.reshaped()) value = *rc::gen::inRange(-1000, 1001) / 1000.0;
  return state;
}

double share() { return *rc::gen::inRange(0, 1001) / 1000.0; }

InitialValueProblem random_problem() {
  const auto bank = find_filter_bank<double>(
      *rc::gen::element<std::string>("db4", "coif2", "sym5", "bspline4.4", "cdf9.7"));
  const int log2 = *rc::gen::inRange(0, 6);
  const Eigen::Index samples = Eigen::Index{1} << log2;
  const Material material = {.density = 0.1 + share(),
                             .stiffness = share(),
                             .mass_damping = share(),
                             .stiffness_damping = 0.01 * share(),
                             .damping_density = share()};
  InitialValueProblem problem = {
      .system = LagrangeSystem(bank, samples, *rc::gen::inRange(0, log2 + 1), material),
      .initial_displacement = random_state(samples, *rc::gen::inRange(1, 4)),
      .times = Eigen::Vector3d(0, share(), 1 + share())};
  const Eigen::Index coordinates = problem.initial_displacement.cols();
  if (*rc::gen::arbitrary<bool>()) problem.initial_velocity = random_state(samples, coordinates);
  if (*rc::gen::arbitrary<bool>()) problem.force.constant = random_state(samples, coordinates);
  if (*rc::gen::arbitrary<bool>()) {
    problem.force.harmonic.push_back({.omega = 10 * share(),
                                      .cosine = random_state(samples, coordinates),
                                      .sine = random_state(samples, coordinates)});
  }
  return problem;
}

double largest(const std::vector<Eigen::MatrixXd>& states) {
  double value = 0;
  for (const Eigen::MatrixXd& state : states) value = std::max(value, state.cwiseAbs().maxCoeff());
  return value;
}

double difference(std::vector<Eigen::MatrixXd> a, const std::vector<Eigen::MatrixXd>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return largest(a);
}

RC_GTEST_PROP(Spectral, IsTheMatrixExponential, ()) {
  const InitialValueProblem problem = random_problem();
  const Trajectory exact = plain::solve_matrix_exponential<long double>(problem);
  const Trajectory spectral = solve_spectral(problem);
  // The entries of M, C, K that the twin starts from are rounded, and the solution moves by that
  // times the number of radians of the fastest oscillation. For biorthogonal bases both the
  // condition of the basis, at most 2^8 here, and the residual of the Gram matrix enter.
  const CirculantEigenvalues symbols = problem.system.eigenvalues();
  const double fastest = std::sqrt((symbols.stiffness.array() / symbols.mass.array()).maxCoeff());
  const double condition = problem.system.bank().is_orthonormal() ? 1 : 256;
  const double bound = 32 * epsilon * condition * (1 + fastest * problem.times[2]);
  // Velocities are exact relative to those that the displacement can turn into.
  const double q = largest(exact.displacement);
  const double v = std::max(largest(exact.velocity), fastest * q);
  RC_ASSERT(difference(spectral.displacement, exact.displacement) <= bound * q);
  RC_ASSERT(difference(spectral.velocity, exact.velocity) <= bound * v);
}

TEST(Spectral, IsTheMatrixExponentialInDoubleAtLargerSizes) {
  for (const char* name : {"coif2", "cdf9.7"}) {
    const LagrangeSystem system(find_filter_bank<double>(name), 128, 7,
                                {.mass_damping = 0.5, .stiffness_damping = 1e-4});
    InitialValueProblem problem = {.system = system,
                                   .initial_displacement = Eigen::MatrixXd::Random(128, 1)};
    problem.times = Eigen::VectorXd::Constant(1, 0.3);
    problem.force.constant = Eigen::MatrixXd::Random(128, 1);
    const Trajectory exact = plain::solve_matrix_exponential<double>(problem);
    const Trajectory spectral = solve_spectral(problem);
    // The exponential squares a dozen times, each time with the rounding of sums of 257 products of
    // entries as large as the fastest frequency; the basis has a condition of at most 2^7.
    const double fastest = std::sqrt(system.eigenvalues().stiffness.maxCoeff());
    const double bound = 128 * 16 * epsilon * fastest * largest(exact.displacement);
    EXPECT_LE(difference(spectral.displacement, exact.displacement), bound) << name;
  }
}

TEST(Spectral, TendsToTheUndampedMotionAsTheDampingVanishes) {
  const auto solution = [](double s2) {
    const LagrangeSystem system(find_filter_bank<double>("db4"), 64, 6, {.stiffness_damping = s2});
    return solve_spectral(
        {system,
         uniform_density(system, Eigen::RowVector2d(1, 2)) + Eigen::MatrixXd::Identity(64, 2),
         {},
         Eigen::Vector2d(0.5, 1),
         {},
         {}});
  };
  const Trajectory limit = solution(0);
  double last = difference(solution(1e-7).displacement, limit.displacement);
  for (const double s2 : {1e-8, 1e-9}) {
    const double now = difference(solution(s2).displacement, limit.displacement);
    EXPECT_NEAR(now / last, 0.1, 0.01);  // of first order in the damping
    last = now;
  }
}

TEST(Spectral, EquallySpacedTimesGiveWhatSingleTimesGive) {
  const LagrangeSystem system(find_filter_bank<double>("db4"), 64, 6,
                              {.mass_damping = 0.3, .stiffness_damping = 1e-4});
  InitialValueProblem problem = {.system = system,
                                 .initial_displacement = Eigen::MatrixXd::Random(64, 2)};
  problem.force.constant = uniform_density(system, Eigen::RowVector2d(0, 3));
  problem.times = Eigen::VectorXd::LinSpaced(61, 0, 3);
  const Trajectory all = solve_spectral(problem);
  for (const Eigen::Index i : {0, 1, 17, 60}) {
    InitialValueProblem single = problem;
    single.times = problem.times.segment(i, 1);
    const Trajectory one = solve_spectral(single);
    const double fastest = std::sqrt(system.eigenvalues().stiffness.maxCoeff());
    const double bound = 16 * epsilon * (1 + fastest * problem.times[i]);
    const auto at = static_cast<std::size_t>(i);
    EXPECT_LE(difference({all.displacement[at]}, one.displacement),
              bound * largest(all.displacement));
    EXPECT_LE(difference({all.velocity[at]}, one.velocity), bound * largest(all.velocity));
  }
}

TEST(Spectral, OneFrameWithoutVelocitiesIsTheSame) {
  const LagrangeSystem system(find_filter_bank<double>("db4"), 64, 6,
                              {.mass_damping = 0.3, .stiffness_damping = 1e-4});
  for (const bool at_rest : {false, true}) {
    for (const bool is_free : {false, true}) {
      InitialValueProblem problem = {.system = system,
                                     .initial_displacement = Eigen::MatrixXd::Random(64, 2)};
      problem.times = Eigen::VectorXd::Constant(1, 0.7);
      if (!at_rest) problem.initial_velocity = Eigen::MatrixXd::Random(64, 2);
      if (!is_free) problem.force.constant = uniform_density(system, Eigen::RowVector2d(0, 3));
      const Trajectory whole = solve_spectral(problem);
      problem.with_velocities = false;
      EXPECT_EQ(solve_spectral(problem).displacement[0], whole.displacement[0]);
    }
  }
}

/// 1/2 v^T M v + 1/2 q^T K q.
double energy(const LagrangeSystem& system, const Eigen::MatrixXd& q, const Eigen::MatrixXd& v) {
  return 0.5 * ((v.transpose() * system.mass() * v).trace() +
                (q.transpose() * system.stiffness() * q).trace());
}

TEST(Spectral, ConservesTheEnergyUndampedAndNeverGainsDamped) {
  for (const char* name : {"db4", "bspline4.4"}) {
    for (const double s2 : {0.0, 1e-3}) {
      const LagrangeSystem system(find_filter_bank<double>(name), 128, 5,
                                  {.density = 2, .stiffness = 3, .stiffness_damping = s2});
      const InitialValueProblem problem = {.system = system,
                                           .initial_displacement = Eigen::MatrixXd::Random(128, 2),
                                           .times = Eigen::VectorXd::LinSpaced(33, 0, 10)};
      const Trajectory trajectory = solve_spectral(problem);
      const double start =
          energy(system, problem.initial_displacement, Eigen::MatrixXd::Zero(128, 2));
      double last = start;
      for (std::size_t i = 0; i < trajectory.displacement.size(); ++i) {
        const double now = energy(system, trajectory.displacement[i], trajectory.velocity[i]);
        if (s2 == 0) {
          EXPECT_NEAR(now / start, 1, 1e-10) << name << i;
        } else {
          EXPECT_LE(now, last * (1 + 1e-12)) << name << i;
        }
        last = now;
      }
    }
  }
}

TEST(Spectral, ATranslationFallsFreely) {
  const LagrangeSystem system(find_filter_bank<double>("coif2"), 32, 3, {.density = 2});
  InitialValueProblem problem = {.system = system,
                                 .initial_displacement = Eigen::MatrixXd::Zero(32, 2),
                                 .times = Eigen::Vector2d(1, 3)};
  problem.force.constant = uniform_density(system, Eigen::RowVector2d(0, 5));
  const Trajectory trajectory = solve_spectral(problem);
  const Eigen::MatrixXd expected = uniform_density(system, Eigen::RowVector2d(0, 5.0 / 2 * 9 / 2));
  EXPECT_LE((trajectory.displacement[1] - expected).cwiseAbs().maxCoeff(), 64 * epsilon * 22.5);
}

TEST(Spectral, RefusesWhatDoesNotFit) {
  const auto bank = find_filter_bank<double>("db4");
  InitialValueProblem problem = {
      .system = LagrangeSystem(bank, 16, 2, {.density = 0, .stiffness_damping = 1}),
      .initial_displacement = Eigen::MatrixXd::Random(16, 2),
      .times = Eigen::Vector2d(0, 1)};
  EXPECT_THROW(solve_spectral(problem), std::domain_error);
  problem.system = LagrangeSystem(bank, 16, 2, {});
  EXPECT_NO_THROW(solve_spectral(problem));
  problem.times = Eigen::Vector2d(1, 0);
  EXPECT_THROW(solve_spectral(problem), std::invalid_argument);
  problem.times = Eigen::Vector2d(0, 1);
  EXPECT_THROW(LagrangeSystem(bank, 16, 2, {.density = -1, .stiffness_damping = 1}),
               std::invalid_argument);
  EXPECT_THROW(LagrangeSystem(bank, 16, 5, {}), std::invalid_argument);
  EXPECT_THROW(LagrangeSystem(find_filter_bank<double>("db2"), 16, 4, {}), std::domain_error);
}

}  // namespace
}  // namespace wavecurve::dynamics
