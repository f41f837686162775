// "The fourth-order Runge-Kutta formula", Euler's method "though less accurate" (section 3.3): the
// orders at which the integration errors fall, against the exact motion.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <fmt/format.h>

#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/dynamics/solver.hpp"
#include "wavecurve/dynamics/stepping/detail/equation_of_motion.hpp"
#include "wavecurve/dynamics/stepping/massless.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"

#include "verification/study/motion_error.hpp"
#include "verification/study/named_shapes.hpp"
#include "verification/study/power_fit.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification::integration_orders_claim {

namespace {

namespace odeint = boost::numeric::odeint;

using Eigen::Index;
using State = std::vector<double>;  ///< displacement, then velocity, column by column

constexpr Index samples = 32;
/// What the next power of the step adds to the slope at the coarsest of these steps. Over
/// evaluations the slope may be steeper: those of the first and of refused steps weigh less as the
/// steps get shorter.
constexpr double agreement = 0.15, excess = 0.5;

const wavecurve::dynamics::Material elastic{};
/// At t = 1 a fifteenth of the star is left, and explicit Euler is stable up to steps of 0.1 at
/// least, 2 s_2.
const wavecurve::dynamics::Material massless = {
    .density = 0, .stiffness = 0.1, .stiffness_damping = 0.05, .damping_density = 20};

dynamics::InitialValueProblem problem_of(const wavecurve::dynamics::Material& material) {
  const dynamics::LagrangeSystem system(find_filter_bank<double>("db4"), samples,
                                        all_levels(samples), material);
  return released(system, named_shape("star", samples), Eigen::VectorXd::Constant(1, 1));
}

/// The error at t = 1 and the number of steps or evaluations.
struct Measured {
  double cost, error;
};

Measured measured(const dynamics::InitialValueProblem& problem,
                  const dynamics::Trajectory& solution, double cost) {
  return {cost, displacement_errors(problem, solution, dynamics::solve_spectral(problem))[0]};
}

/// A formula of Boost.Odeint in equal steps, without control.
template <class Stepper>
Measured in_equal_steps(int steps) {
  const dynamics::InitialValueProblem problem = problem_of(elastic);
  dynamics::EquationOfMotion motion(problem, false);
  const Index half = problem.initial_displacement.size();
  State state(static_cast<std::size_t>(2 * half), 0.0);
  std::copy_n(problem.initial_displacement.data(), half, state.begin());
  const auto derivative = [&](const State& x, State& dxdt, double t) {
    using In = Eigen::Map<const Eigen::MatrixXd>;
    std::copy(x.begin() + half, x.end(), dxdt.begin());
    motion(t, In(x.data(), samples, 2), In(x.data() + half, samples, 2),
           Eigen::Map<Eigen::MatrixXd>(dxdt.data() + half, samples, 2));
  };
  Stepper stepper;
  const double h = 1.0 / steps;
  for (int i = 0; i < steps; ++i) stepper.do_step(derivative, state, i * h, h);
  dynamics::Trajectory solution;
  solution.displacement.push_back(Eigen::Map<Eigen::MatrixXd>(state.data(), samples, 2));
  return measured(problem, solution, steps);
}

struct Method {
  std::string name;
  int nominal;
  std::string counted;  ///< the cost that the order is of
  std::vector<Measured> points;
};

template <class Stepper>
Method formula(const char* name, int nominal) {
  Method method{std::string(name) + ", equal steps", nominal, "steps", {}};
  for (int steps = 256; steps <= 2048; steps *= 2) {
    method.points.push_back(in_equal_steps<Stepper>(steps));
  }
  return method;
}

Method of_massless(const char* name, int nominal, dynamics::MasslessMethod kind) {
  Method method{name, nominal, "steps", {}};
  const dynamics::InitialValueProblem problem = problem_of(massless);
  for (int steps = 64; steps <= 1024; steps *= 2) {
    method.points.push_back(
        measured(problem, dynamics::solve_massless(problem, kind, 1.0 / steps), steps));
  }
  return method;
}

/// One of the library's solvers, over its evaluations.
Method of_solver(const char* name, const char* solver, int nominal,
                 const std::vector<double>& accuracies) {
  Method method{name, nominal, "evaluations", {}};
  const dynamics::InitialValueProblem problem = problem_of(elastic);
  for (const double accuracy : accuracies) {
    const dynamics::Trajectory solution =
        dynamics::find_solver(solver).make({.tolerance = accuracy, .step = accuracy})(problem);
    method.points.push_back(
        measured(problem, solution, static_cast<double>(solution.cost.evaluations)));
  }
  return method;
}

std::vector<Method> methods() {
  const std::vector<double> fine = {1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
  return {of_massless("Euler, C^-1 by Schulz", 1, dynamics::MasslessMethod::schulz_euler),
          of_massless("Euler, C factorised", 1, dynamics::MasslessMethod::explicit_euler),
          of_massless("backward Euler", 1, dynamics::MasslessMethod::backward_euler),
          of_massless("Crank-Nicolson", 2, dynamics::MasslessMethod::crank_nicolson),
          formula<odeint::runge_kutta4<State>>("Runge-Kutta 4", 4),
          formula<odeint::runge_kutta_cash_karp54<State>>("Cash-Karp", 5),
          formula<odeint::runge_kutta_dopri5<State>>("Dormand-Prince", 5),
          of_solver("Runge-Kutta 4, step doubling", "coupled", 5, fine),
          of_solver("Cash-Karp, controlled", "coupled-cash-karp", 5, fine),
          of_solver("Dormand-Prince, controlled", "coupled-dormand-prince", 5, fine),
          of_solver("Newmark", "implicit", 2, {1.0 / 256, 1.0 / 512, 1.0 / 1024, 1.0 / 2048}),
          of_solver("Rosenbrock, controlled", "implicit-rosenbrock", 3, {1e-5, 1e-6, 1e-7, 1e-8})};
}

PowerFit order_of(const Method& method) {
  State inverse_costs, errors;
  for (const auto& [cost, error] : method.points) {
    inverse_costs.push_back(1 / cost);
    errors.push_back(error);
  }
  return fit_power(inverse_costs, errors);
}

bool is_nominal(const Method& method, const PowerFit& fit) {
  const double above = method.counted == "steps" ? agreement : excess;
  return fit.exponent >= method.nominal - agreement && fit.exponent <= method.nominal + above;
}

Chart order_chart(const std::vector<Method>& all) {
  Chart chart;
  chart.id = "integration-orders";
  chart.data = {
      "L2 error of the displacement at t = 1, relative to the initial one, over the number of steps; "
      "star, D8, N = 32",
      {"steps"},
      {}};
  std::string plots;
  std::vector<const Method*> shown;
  for (const Method& method : all) {
    if (method.counted != "steps" || method.name.find("factorised") != std::string::npos) continue;
    shown.push_back(&method);
    chart.data.columns.push_back(fmt::format("{} ({})", method.name, method.nominal));
    plots += fmt::format("{}data using 1:{} with linespoints linetype {}",
                         plots.empty() ? "" : ", ", shown.size() + 1, shown.size());
  }
  for (int steps = 64; steps <= 2048; steps *= 2) {
    std::vector<std::string> row = {std::to_string(steps)};
    for (const Method* method : shown) {
      const auto found = std::ranges::find(method->points, steps, &Measured::cost);
      row.push_back(found == method->points.end() ? "" : fmt::format("{:.2e}", found->error));
    }
    chart.data.rows.push_back(row);
  }
  chart.script =
      "set linetype 6 linecolor rgb \"#8a6d00\" linewidth 2 dashtype 1 pointtype 6 pointsize 0.8\n"
      "set logscale xy\nset logscale x 2\nset format y \"10^{%T}\"\nset xlabel \"steps\"\n"
      "set ylabel \"error relative to the initial displacement\"\nplot " +
      plots + "\n";
  return chart;
}

Outcome evaluate() {
  const std::vector<Method> all = methods();
  Table table{
      "Observed orders: slopes in double logarithmic scale, intervals of 95 % (Student's). "
      "The controlled ones choose their steps, which scatters; Runge-Kutta 4 with step "
      "doubling improves its result by the estimate, and so has order 5",
      {"method", "nominal order", "observed", "interval", "of", "points", "error, coarsest",
       "error, finest"},
      {}};
  std::size_t nominal = 0;
  double low = 0, high = 0;
  for (const Method& method : all) {
    const PowerFit fit = order_of(method);
    if (is_nominal(method, fit)) ++nominal;
    table.rows.push_back(
        {method.name, std::to_string(method.nominal), fmt::format("{:.2f}", fit.exponent),
         fmt::format("{:.2f} to {:.2f}", fit.low, fit.high), method.counted,
         std::to_string(fit.points), fmt::format("{:.1e}", method.points.front().error),
         fmt::format("{:.1e}", method.points.back().error)});
    if (method.name.starts_with("Euler, C^-1")) low = fit.exponent;
    if (method.name == "Runge-Kutta 4, equal steps") high = fit.exponent;
  }
  Outcome outcome;
  outcome.verdict = nominal == all.size() ? ClaimVerdict::holds : ClaimVerdict::undecided;
  outcome.finding = {"Euler {}, Runge-Kutta {}; {} of {} methods have their order",
                     {to_decimals("order of Euler's method", low, 2),
                      to_decimals("order of the Runge-Kutta formula, equal steps", high, 2),
                      counted("methods with their order", static_cast<long long>(nominal)),
                      counted("methods", std::ssize(all))}};
  outcome.summary =
      "Each method's error against the exact motion falls at its nominal order, before rounding "
      "and "
      "beyond what stability asks of the step. These are integration errors; what a decoupled "
      "model "
      "adds no order takes away.";
  outcome.evidence = {order_chart(all), table};
  return outcome;
}

const RegisterClaim registered(
    {"integration-orders", "Euler's method is of order 1, the Runge-Kutta formula of order 4",
     "Section 3.3",
     "We use the fourth-order Runge-Kutta formula and an adaptive stepsize controller; Euler's "
     "method [...] though less accurate, this method is simple",
     evaluate});

}  // namespace

}  // namespace wavecurve::verification::integration_orders_claim
