#include "wavecurve/dynamics/stepping/coupled.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <fmt/format.h>

#include "wavecurve/dynamics/detail/tolerance.hpp"
#include "wavecurve/dynamics/detail/work_bound.hpp"
#include "wavecurve/dynamics/stepping/detail/equation_of_motion.hpp"
#include "wavecurve/elementary/root.hpp"

namespace wavecurve::dynamics {

namespace {

namespace odeint = boost::numeric::odeint;

using State = std::vector<double>;  ///< displacement, then velocity, each column by column
using ConstMap = Eigen::Map<const Eigen::VectorXd>;

/// A step's error over what is allowed.
class ErrorNorm {
 public:
  explicit ErrorNorm(double tolerance) : tolerance_(tolerance) {}

  double operator()(const State& x, const State& dxdt, const State& error, double h) const {
    const auto half = static_cast<Eigen::Index>(x.size() / 2);
    double largest = 0;
    for (const Eigen::Index at : {Eigen::Index{0}, half}) {
      const double e = ConstMap(error.data() + at, half).norm();
      const double scale = ConstMap(x.data() + at, half).norm() +
                           std::abs(h) * ConstMap(dxdt.data() + at, half).norm();
      if (e > 0) largest = std::max(largest, e / (tolerance_ * scale));
      if (std::isnan(e)) return std::numeric_limits<double>::infinity();  // a step never accepted
    }
    return largest;
  }

  /// As Odeint calls it.
  template <class Algebra>
  double error(Algebra&, const State& x, const State& dxdt, const State& error, double h) const {
    return (*this)(x, dxdt, error, h);
  }

 private:
  double tolerance_;
};

/// How Odeint changes a step, with roots that are the same on every processor, as pow is not.
class StepAdjuster {
 public:
  double decrease_step(double h, double error, int error_order) const {
    return h * std::max(0.9 * root(1 / error, error_order - 1), 0.2);
  }
  /// Up to 4.5 times the step; below half of what is allowed, for growth that is soon undone is dear.
  double increase_step(double h, double error, int order) const {
    if (error >= 0.5) return h;
    return h * 0.9 * std::min(root(1 / error, order), 5.0);
  }
  bool check_step_size_limit(double) const { return true; }  // there is none
  double get_max_dt() const { return 0; }
};

/// Classic Runge-Kutta steps with their halves, a controlled stepper as Odeint's are.
class StepDoubling {
 public:
  explicit StepDoubling(ErrorNorm norm) : norm_(norm) {}

  template <class System>
  odeint::controlled_step_result try_step(System system, State& x, double& t, double& h) {
    for (State* state : {&dxdt_, &coarse_, &middle_, &fine_}) state->resize(x.size());
    system(x, dxdt_, t);
    stepper_.do_step(system, x, dxdt_, t, coarse_, h);
    stepper_.do_step(system, x, dxdt_, t, middle_, h / 2);
    stepper_.do_step(system, middle_, t + h / 2, fine_, h / 2);
    for (std::size_t i = 0; i < x.size(); ++i) coarse_[i] = (fine_[i] - coarse_[i]) / 15;
    const double error = norm_(x, dxdt_, coarse_, h);
    // The error of a step of order 4 goes with h^5; growing less boldly than shrinking is usual.
    if (error > 1) {
      h *= std::max(0.9 * root(1 / error, 4), 0.2);
      return odeint::fail;
    }
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = fine_[i] + coarse_[i];
    t += h;
    h *= error > 0 ? std::min(0.9 * root(1 / error, 5), 5.0) : 5.0;
    return odeint::success;
  }

 private:
  ErrorNorm norm_;
  odeint::runge_kutta4<State> stepper_;
  State dxdt_, coarse_, middle_, fine_;
};

void check_step_size(double t, double h, double end) {
  const double smallest = 16 * std::numeric_limits<double>::epsilon() * end;
  if (h >= smallest) return;
  throw std::domain_error(
      fmt::format("the step size falls to {} at time {}, below {}", h, t, smallest));
}

class Integration {
 public:
  Integration(const InitialValueProblem& problem, bool dense)
      : problem_(problem),
        motion_(problem, dense),
        rows_(problem.system.samples()),
        columns_(problem.initial_displacement.cols()),
        state_(static_cast<std::size_t>(2 * rows_ * columns_)) {
    block(state_, 0) = problem.initial_displacement;
    if (problem.initial_velocity.size() > 0) block(state_, 1) = problem.initial_velocity;
  }

  /// The right-hand side.
  void operator()(const State& x, State& dxdt, double t) {
    block(dxdt, 0) = block(x, 1);
    motion_(t, block(x, 0), block(x, 1), block(dxdt, 1));
  }

  template <class Stepper>
  Trajectory with_cut_steps(Stepper stepper) {
    double t = 0, h = first_step();
    return run([&](double end) {
      while (t < end) {
        double taken = std::min(h, end - t);
        const bool is_cut = taken < h;
        const double suggested = h, before = t;
        const auto result = stepper.try_step(std::ref(*this), state_, t, taken);
        count_stages();
        check_work(operations(), t, last_time());
        h = result == odeint::success && is_cut ? std::max(suggested, taken) : taken;
        if (result == odeint::success && end - t < 4 * std::numeric_limits<double>::epsilon() * end)
          t = end;
        if (result == odeint::fail) check_step_size(before, h, last_time());
      }
      return &state_;
    });
  }

  template <class Stepper>
  Trajectory with_dense_output(Stepper stepper) {
    stepper.initialize(state_, 0, first_step());
    return run([&](double end) {
      while (stepper.current_time() < end) {
        try {
          stepper.do_step(std::ref(*this));
        } catch (const odeint::odeint_error&) {  // 500 steps refused in a row
          check_step_size(stepper.current_time(), 0, last_time());
        }
        count_stages();
        check_work(operations(), stepper.current_time(), last_time());
        check_step_size(stepper.current_time(), stepper.current_time_step(), last_time());
      }
      if (end > 0) stepper.calc_state(end, state_);
      return &state_;
    });
  }

 private:
  /// The displacement, which = 0, or the velocity, 1.
  Eigen::Map<Eigen::MatrixXd> block(State& x, Eigen::Index which) const {
    return {x.data() + which * rows_ * columns_, rows_, columns_};
  }
  Eigen::Map<const Eigen::MatrixXd> block(const State& x, Eigen::Index which) const {
    return {x.data() + which * rows_ * columns_, rows_, columns_};
  }

  template <class Reach>
  Trajectory run(Reach reach) {
    Trajectory trajectory;
    keep_what_is_reached(trajectory, [&] {
      for (const double time : problem_.times) {
        const State& state = *reach(time);
        trajectory.displacement.push_back(block(state, 0));
        if (problem_.with_velocities) trajectory.velocity.push_back(block(state, 1));
        trajectory.cost = motion_.cost();
        trajectory.cost.operations = operations();
      }
    });
    return trajectory;
  }

  /// One radian of the fastest oscillation: what comes next, the control finds.
  double first_step() const {
    const CirculantEigenvalues symbols = problem_.system.eigenvalues();
    const double fastest =
        std::sqrt((symbols.stiffness.array() / symbols.mass.array()).maxCoeff()) +
        (symbols.damping.array() / symbols.mass.array()).maxCoeff();
    const double end = last_time() > 0 ? last_time() : 1;
    return fastest > 0 ? std::min(end, 1 / fastest) : end;
  }

  double last_time() const {
    return problem_.times.size() > 0 ? problem_.times[problem_.times.size() - 1] : 0;
  }

  long long operations() const { return motion_.cost().operations + stage_operations_; }

  /// Sums of stages: about two operations a value and evaluation, three stages on an average each.
  void count_stages() { stage_operations_ = 6 * motion_.cost().evaluations * 2 * rows_ * columns_; }

  const InitialValueProblem& problem_;
  EquationOfMotion motion_;
  Eigen::Index rows_, columns_;
  State state_;
  long long stage_operations_ = 0;
};

Trajectory solve(const InitialValueProblem& problem, RungeKutta method, double tolerance,
                 bool dense) {
  check(problem);
  check_tolerance(tolerance);
  const ErrorNorm norm(tolerance);
  Integration integration(problem, dense);
  if (method == RungeKutta::step_doubling) return integration.with_cut_steps(StepDoubling(norm));
  if (method == RungeKutta::cash_karp) {
    return integration.with_cut_steps(
        odeint::controlled_runge_kutta<odeint::runge_kutta_cash_karp54<State>, ErrorNorm,
                                       StepAdjuster>(norm));
  }
  using Controlled =
      odeint::controlled_runge_kutta<odeint::runge_kutta_dopri5<State>, ErrorNorm, StepAdjuster>;
  return integration.with_dense_output(
      odeint::dense_output_runge_kutta<Controlled>(Controlled(norm)));
}

}  // namespace

Trajectory solve_coupled(const InitialValueProblem& problem, RungeKutta method, double tolerance) {
  return solve(problem, method, tolerance, false);
}

namespace plain {

Trajectory solve_coupled(const InitialValueProblem& problem, RungeKutta method, double tolerance) {
  return solve(problem, method, tolerance, true);
}

}  // namespace plain

}  // namespace wavecurve::dynamics
