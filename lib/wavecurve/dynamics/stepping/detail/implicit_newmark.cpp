#include <stdexcept>

#include "wavecurve/dynamics/detail/tolerance.hpp"
#include "wavecurve/dynamics/stepping/detail/fixed_steps.hpp"
#include "wavecurve/dynamics/stepping/detail/implicit.hpp"
#include "wavecurve/dynamics/stepping/detail/residual_force.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::dynamics {

namespace {

constexpr double residual = 1e-12;  ///< of the linear systems: below what any step's error is

class Newmark {
 public:
  Newmark(const InitialValueProblem& problem, LinearSolver method)
      : system_(problem.system),
        method_(method),
        balance_(problem),
        q_(problem.initial_displacement),
        v_(problem.initial_velocity) {
    if (v_.size() == 0) v_ = Eigen::MatrixXd::Zero(q_.rows(), q_.cols());
    a_ = Eigen::MatrixXd::Zero(q_.rows(), q_.cols());
    const auto mass = shifted_solver(system_, balance_.density(), 0, method_, residual);
    mass->solve(balance_(balance_.load(0, q_, v_), q_, v_), a_);
  }

  void set_step(double h) {
    h_ = h;
    if (solver_) operations_ += solver_->operations();
    solver_ = shifted_solver(system_, balance_.density() + h / 2 * balance_.gram_damping(),
                             h / 2 * balance_.stiffness_damping() + h * h / 4, method_, residual);
  }

  void step(double t) {
    const double h = h_;
    const Eigen::MatrixXd load = balance_.load(t + h, q_ + h * v_ + h * h / 2 * a_, v_ + h * a_);
    q_ += h * v_ + h * h / 4 * a_;
    v_ += h / 2 * a_;
    solver_->solve(balance_(load, q_, v_), a_);
    q_ += h * h / 4 * a_;
    v_ += h / 2 * a_;
    ++evaluations_;
  }

  const Eigen::MatrixXd& displacement() const { return q_; }
  Eigen::MatrixXd velocity(double) const { return v_; }
  Cost cost() const {
    const long long solving = operations_ + (solver_ ? solver_->operations() : 0);
    return {evaluations_, balance_.operations() + solving + 12 * evaluations_ * q_.size()};
  }

 private:
  const LagrangeSystem& system_;
  LinearSolver method_;
  ResidualForce balance_;
  Eigen::MatrixXd q_, v_, a_;
  double h_ = 0;
  std::unique_ptr<ShiftedSolver> solver_;
  long long evaluations_ = 0, operations_ = 0;
};

}  // namespace

Trajectory solve_newmark(const InitialValueProblem& problem, double step, LinearSolver method) {
  check(problem);
  check_step(step);
  if (problem.system.material().density == 0) {
    throw std::domain_error(must_be("density", 0, "above 0 here"));
  }
  return in_fixed_steps(problem, step, [&] { return Newmark(problem, method); });
}

}  // namespace wavecurve::dynamics
