#include "wavecurve/dynamics/solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/dynamics/problem_test.hpp"

namespace wavecurve::dynamics {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

const std::vector<std::string> filters = {"db4", "bspline4.4"};

/// A solver of the coupled system and the accuracies it is tried with, the error it should have at
/// the finest, and how fast it should fall: the order, in powers of a step or of a tolerance.
struct Trial {
  std::string name;
  std::vector<double> accuracies;
  double order;
};

const std::vector<Trial> trials = {
    // The estimate is of order h^5, and the result that is kept of order 5: its global error goes
    // with the tolerance. Rosenbrock: the estimate h^3, the result of order 3.
    {"coupled", {1e-4, 1e-6, 1e-8}, 1},
    {"coupled-cash-karp", {1e-4, 1e-6, 1e-8}, 1},
    {"coupled-dormand-prince", {1e-4, 1e-6, 1e-8}, 1},
    {"coupled-dense", {1e-4, 1e-6, 1e-8}, 1},
    {"implicit-rosenbrock", {1e-4, 1e-5, 1e-6}, 1},
    {"implicit-rosenbrock-ldlt", {1e-4, 1e-5, 1e-6}, 1},
    {"implicit", {1.0 / 64, 1.0 / 256, 1.0 / 1024}, 2},
    {"implicit-ldlt", {1.0 / 64, 1.0 / 256, 1.0 / 1024}, 2},
};

TEST(Solvers, ThoseOfTheCoupledSystemAreAllTried) {
  for (const NamedSolver& solver : solvers()) {
    if (solver.is_massless || solver.accuracy == AccuracyKind::closed_form) continue;
    EXPECT_TRUE(
        std::ranges::any_of(trials, [&](const Trial& trial) { return trial.name == solver.name; }))
        << solver.name << " is in no trial";
  }
}

/// The number as whichever the solver takes.
Accuracy either(double number) { return {.tolerance = number, .step = number}; }

InitialValueProblem forced_problem(const std::string& filter) {
  InitialValueProblem problem = smooth_problem(filter, 32,
                                               {.density = 1.5,
                                                .stiffness = 0.8,
                                                .mass_damping = 0.2,
                                                .stiffness_damping = 1e-3,
                                                .damping_density = 0.1});
  problem.initial_velocity = -0.7 * problem.initial_displacement;
  problem.force.constant = uniform_density(problem.system, Eigen::RowVector2d(0.1, -1));
  problem.force.harmonic.push_back({.omega = 4,
                                    .cosine = problem.initial_displacement,
                                    .sine = 0.5 * problem.initial_displacement});
  return problem;
}

TEST(Solvers, TendToTheExactSolutionAtTheirOrder) {
  for (const std::string& filter : filters) {
    const InitialValueProblem problem = forced_problem(filter);
    const Trajectory exact = solve_spectral(problem);
    for (const Trial& trial : trials) {
      std::vector<double> errors;
      for (const double accuracy : trial.accuracies) {
        const Trajectory solution = find_solver(trial.name).make(either(accuracy))(problem);
        errors.push_back(largest_difference(solution.displacement, exact.displacement));
        EXPECT_GT(solution.cost.operations, 0);
      }
      const double order = std::log(errors.front() / errors.back()) /
                           std::log(trial.accuracies.front() / trial.accuracies.back());
      // Steps are not fine enough throughout for the order to be sharp: a tenth and a half.
      EXPECT_GT(order, 0.9 * trial.order) << trial.name << " " << filter;
      EXPECT_LT(errors.back(), 1e-3) << trial.name << " " << filter;
      EXPECT_LT(order, 1.5 * trial.order + 0.2) << trial.name << " " << filter;
    }
  }
}

TEST(Solvers, TheMatrixFreeOneIsItsDenseTwin) {
  for (const std::string& filter : filters) {
    const InitialValueProblem problem = forced_problem(filter);
    const Trajectory fast = find_solver("coupled").make({.tolerance = 1e-6})(problem);
    const Trajectory plain = find_solver("coupled-dense").make({.tolerance = 1e-6})(problem);
    // The same steps, with rounding alone between them: thousands of operations of size 1.
    EXPECT_EQ(fast.cost.evaluations, plain.cost.evaluations);
    EXPECT_LT(largest_difference(fast.displacement, plain.displacement), 1e5 * epsilon);
    EXPECT_LT(largest_difference(fast.velocity, plain.velocity), 1e6 * epsilon);
  }
}

TEST(Solvers, SolveOneModeAsOnPaper) {
  // On the circle of 64 samples, mode 1: q'' + 0.3 q' + k q = 0 with the symbol k, near (2 pi)^2.
  InitialValueProblem problem = smooth_problem("db4", 64, {.mass_damping = 0.3});
  problem.initial_displacement.col(0) = problem.initial_displacement.col(1);
  const double k = problem.system.eigenvalues().stiffness[1], decay = 0.15;
  const double omega = std::sqrt(k - decay * decay);
  const auto expect = [&](const std::string& name, double accuracy, double bound) {
    const Trajectory solution = find_solver(name).make(either(accuracy))(problem);
    for (std::size_t i = 0; i < solution.displacement.size(); ++i) {
      const double t = problem.times[static_cast<Eigen::Index>(i)], sine = std::sin(omega * t);
      const double fading = std::exp(-decay * t);
      const double factor = fading * (std::cos(omega * t) + decay / omega * sine);
      EXPECT_LT((solution.displacement[i] - factor * problem.initial_displacement).norm(),
                bound * problem.initial_displacement.norm())
          << name << " at " << t;
      const double speed = -fading * k / omega * sine;
      EXPECT_LT((solution.velocity[i] - speed * problem.initial_displacement).norm(),
                bound * omega * problem.initial_displacement.norm())
          << name << " at " << t;
    }
  };
  for (const Trial& trial : trials) expect(trial.name, trial.accuracies.back(), 2e-4);
  // The closed form leaves what rounding makes of the other modes, up to omega = 600.
  expect("spectral", 1e-9, 1e4 * epsilon);
}

/// At an accuracy that is cheap.
Solver cheap(const NamedSolver& solver) {
  return solver.make({.tolerance = 1e-5, .step = 1.0 / 64});
}

/// All that solve the equation of second order.
std::vector<Solver> all_solvers() {
  std::vector<Solver> result;
  for (const NamedSolver& solver : solvers()) {
    if (!solver.is_massless) result.push_back(cheap(solver));
  }
  return result;
}

TEST(Solvers, ShiftTheSolutionWithTheStartPoint) {
  const LagrangeSystem system(find_filter_bank<double>("db4"), 64, 3, {.mass_damping = 0.1});
  const Eigen::Index shift = 2 * 8;  // twice the coarsest spacing
  InitialValueProblem problem = {.system = system, .times = Eigen::Vector2d(0.2, 0.5)};
  for (const NamedSolver& named : solvers()) {
    if (named.is_massless) continue;
    const Solver solver = cheap(named);
    problem.initial_displacement = coefficients_of(system, smooth_samples(64));
    const Trajectory original = solver(problem);
    problem.initial_displacement = coefficients_of(system, smooth_samples(64, shift));
    Trajectory moved = solver(problem);
    for (Eigen::MatrixXd& state : moved.displacement) state = shifted(system, state, -shift + 64);
    // Closed forms: rounding. Newmark: 32 steps, each with residuals of 1e-12. The others may
    // choose other steps where rounding tips the scale.
    const double bound = named.accuracy == AccuracyKind::closed_form ? 1e4 * epsilon
                         : named.accuracy == AccuracyKind::step      ? 1e-9
                                                                     : 1e-4;
    EXPECT_LT(largest_difference(moved.displacement, original.displacement), bound) << named.name;
  }
}

TEST(Solvers, AreLinearInStartAndForce) {
  InitialValueProblem problem =
      smooth_problem("cdf9.7", 32, {.mass_damping = 0.1, .stiffness_damping = 1e-4});
  problem.force.constant = 2 * problem.initial_displacement;
  InitialValueProblem twice = problem;
  twice.initial_displacement *= 2;
  twice.force.constant *= 2;
  for (const Solver& solver : all_solvers()) {
    const Trajectory once = solver(problem);
    Trajectory both = solver(twice);
    for (Eigen::MatrixXd& state : both.displacement) state /= 2;
    // Steps are chosen by relative errors, so they are the same; a factor of 2 is exact.
    EXPECT_LT(largest_difference(once.displacement, both.displacement), 1e-12);
  }
}

TEST(Solvers, RunBackwardsWithoutDamping) {
  InitialValueProblem problem = smooth_problem("db4", 32, {});
  problem.times = Eigen::VectorXd::Constant(1, 0.4);
  for (const NamedSolver& named : solvers()) {
    if (named.is_massless) continue;
    const Solver solver = named.make({.tolerance = 1e-6, .step = 1.0 / 64});
    InitialValueProblem back = problem;
    const Trajectory there = solver(problem);
    back.initial_displacement = there.displacement[0];
    back.initial_velocity = -there.velocity[0];
    const Trajectory again = solver(back);
    // Newmark's method is symmetric in time, the closed forms exact: rounding and residuals alone.
    const double bound = named.accuracy == AccuracyKind::tolerance ? 1e-3 : 1e-9;
    EXPECT_LT((again.displacement[0] - problem.initial_displacement).norm(),
              bound * problem.initial_displacement.norm())
        << named.name;
  }
}

/// The largest differences from the limit as a constant of the material falls by tenths.
std::vector<double> differences(const Solver& solver, const Trajectory& limit, Material material,
                                double Material::*constant, const std::vector<double>& values) {
  std::vector<double> result;
  for (const double value : values) {
    material.*constant = value;
    const Trajectory solution = solver(smooth_problem("db4", 16, material));
    result.push_back(largest_difference(solution.displacement, limit.displacement));
  }
  return result;
}

TEST(Solvers, TendToTheUndampedMotionAsTheDampingVanishes) {
  for (const NamedSolver& named : solvers()) {
    if (named.is_massless) continue;
    const Solver solver = named.make({.tolerance = 1e-8, .step = 1.0 / 64});
    const Material material = {};
    const Trajectory limit = solver(smooth_problem("db4", 16, material));
    const auto found =
        differences(solver, limit, material, &Material::stiffness_damping, {1e-3, 1e-4, 1e-5});
    // The method is of first order; what the controlled ones add is a thousandth of the last.
    for (std::size_t i = 1; i < found.size(); ++i) {
      EXPECT_NEAR(found[i] / found[i - 1], 0.1, 0.02) << named.name << i;
    }
  }
}

TEST(Solvers, TendToTheMasslessMotionAsTheDensityVanishes) {
  for (const NamedSolver& named : solvers()) {
    if (named.is_massless) continue;
    // Steps must resolve the time density / c in which the velocity is found.
    const Solver solver = named.make({.tolerance = 1e-6, .step = 1.0 / 4096});
    const bool is_closed = named.accuracy == AccuracyKind::closed_form;
    const Material material = {
        .density = 0, .stiffness = 0.1, .stiffness_damping = 0.05, .damping_density = 1};
    const Trajectory limit = (is_closed ? solver : find_solver("spectral").make({}))(
        smooth_problem("db4", 16, material));
    const auto found = differences(solver, limit, material, &Material::density, {1e-2, 1e-3});
    for (std::size_t i = 1; i < found.size(); ++i) {
      EXPECT_NEAR(found[i] / found[i - 1], 0.1, 0.02) << named.name << i;
    }
  }
}

TEST(Solvers, StopAtForcesThatFailAndKeepWhatIsReached) {
  for (const Solver& solver : all_solvers()) {
    for (const bool throws : {false, true}) {
      InitialValueProblem problem = smooth_problem("db4", 16, {});
      problem.force.general.push_back(
          [throws](double t, const Eigen::Ref<const Eigen::MatrixXd>& positions, const auto&) {
            if (t > 0.6 && throws) throw std::runtime_error("no force left");
            return Eigen::MatrixXd::Constant(positions.rows(), positions.cols(),
                                             t > 0.6 ? NAN : 0.5);
          });
      try {
        solver(problem);
        ADD_FAILURE() << "no exception";
      } catch (const SolutionStopped& stopped) {
        EXPECT_NE(std::string(stopped.what()).find("general force 0"), std::string::npos);
        EXPECT_NE(std::string(stopped.what()).find("at time 0."), std::string::npos);
        EXPECT_GE(stopped.reached().displacement.size(), 2u);  // 0, 0.25; steps may pass 0.5
        EXPECT_LE(stopped.reached().displacement.size(), 3u);
      }
    }
  }
}

TEST(Solvers, StopWhereTheStepSizeVanishes) {
  for (const char* name : {"coupled", "coupled-cash-karp", "coupled-dormand-prince",
                           "implicit-rosenbrock", "spectral", "decoupled"}) {
    InitialValueProblem problem = smooth_problem("db4", 8, {});
    // q'' = 2 / (1/2 - t)^2 and more: infinite at time 1/2.
    problem.force.general.push_back(
        [](double t, const Eigen::Ref<const Eigen::MatrixXd>& positions, const auto&) {
          return Eigen::MatrixXd::Constant(positions.rows(), positions.cols(),
                                           1 / ((0.5001 - t) * (0.5001 - t)));
        });
    try {
      find_solver(name).make({.tolerance = 1e-8})(problem);
      ADD_FAILURE() << name << ": no exception";
    } catch (const SolutionStopped& stopped) {
      EXPECT_NE(std::string(stopped.what()).find("step size"), std::string::npos)
          << name << stopped.what();
      EXPECT_EQ(stopped.reached().displacement.size(), 3u) << name;
    }
  }
}

TEST(Solvers, TakeTheAccuracyOfTheirKindAlone) {
  for (const NamedSolver& solver : solvers()) {
    const bool is_step = solver.accuracy == AccuracyKind::step;
    const Accuracy other = is_step ? Accuracy{.tolerance = 1e-3} : Accuracy{.step = 1e-3};
    if (solver.accuracy == AccuracyKind::closed_form) {
      EXPECT_NO_THROW(solver.make(other)) << solver.name;
      continue;
    }
    try {
      solver.make(other);
      ADD_FAILURE() << solver.name << ": no exception";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), "solver " + solver.name + " needs a " +
                                  (is_step ? "step" : "tolerance") + ", but none is given");
    }
  }
}

TEST(Solvers, RefuseWhatDoesNotFit) {
  for (const NamedSolver& solver : solvers()) {
    InitialValueProblem problem = smooth_problem("db4", 16, {});
    if (solver.is_massless) {
      EXPECT_THROW(solver.make({.step = 1e-3})(problem), std::domain_error) << solver.name;
      continue;
    }
    if (solver.accuracy != AccuracyKind::closed_form) {
      for (const double value : {0.0, -1.0, double(NAN)}) {
        EXPECT_THROW(solver.make(either(value))(problem), std::invalid_argument) << solver.name;
      }
    }
    problem.times = Eigen::Vector2d(1, 0.5);
    EXPECT_THROW(solver.make(either(0.1))(problem), std::invalid_argument) << solver.name;
    problem = smooth_problem("db4", 16,
                             {.density = 0, .stiffness_damping = 1});  // massless, C = K singular
    EXPECT_THROW(solver.make(either(0.1))(problem), std::domain_error) << solver.name;
  }
  EXPECT_THROW(find_solver("euler"), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::dynamics
