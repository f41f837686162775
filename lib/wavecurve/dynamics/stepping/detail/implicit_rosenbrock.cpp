#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/dynamics/detail/tolerance.hpp"
#include "wavecurve/dynamics/detail/work_bound.hpp"
#include "wavecurve/dynamics/stepping/detail/implicit.hpp"
#include "wavecurve/dynamics/stepping/detail/residual_force.hpp"
#include "wavecurve/elementary/root.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::dynamics {

namespace {

/// The coefficients of ROS34PW2: they define the method.
struct Ros34Pw2 {
  static constexpr double gamma = 0.43586652150845900;
  static constexpr double a[4][4] = {{0, 0, 0, 0},
                                     {0.87173304301691801, 0, 0, 0},
                                     {0.84457060015369423, -0.11299064236484185, 0, 0},
                                     {0, 0, 1, 0}};
  static constexpr double c[4][4] = {
      {0, 0, 0, 0},
      {-0.87173304301691801, 0, 0, 0},
      {-0.90338057013044082, 0.054180672388095326, 0, 0},
      {0.24212380706095346, -1.2232505839045147, 0.54526025533510214, 0}};
  static constexpr double b[4] = {0.24212380706095346, -1.2232505839045147, 1.5452602553351020,
                                  0.43586652150845900};
  static constexpr double embedded[4] = {0.37810903145819369, -0.096042292212423178, 0.5,
                                         0.21793326075422950};
};

class Rosenbrock {
 public:
  Rosenbrock(const InitialValueProblem& problem, double tolerance, LinearSolver method)
      : system_(problem.system),
        tolerance_(tolerance),
        method_(method),
        balance_(problem),
        q_(problem.initial_displacement),
        v_(problem.initial_velocity) {
    if (v_.size() == 0) v_ = Eigen::MatrixXd::Zero(q_.rows(), q_.cols());
  }

  /// From t to end, the last step cut there.
  void advance(double t, double end) {
    if (h_ == 0) h_ = 1e-3 * (end - t);
    while (t < end) {
      check_work(cost().operations);
      const bool is_last = t + h_ >= end * (1 - 1e-14);
      const double h = is_last ? end - t : h_;
      const double error = attempt(t, h);
      const double factor = std::clamp(0.9 / root(error, 3), 0.2, 5.0);
      if (error <= 1) {
        q_ = new_q_;
        v_ = new_v_;
        t = is_last ? end : t + h;
        // Small gains are not worth a new matrix; neither is what a cut step suggests.
        if (factor > 1.2 && (!is_last || factor * h > h_)) h_ = factor * h;
      } else {
        h_ = factor * h;
        const double smallest = 16 * std::numeric_limits<double>::epsilon() * end;
        if (!(h_ >= smallest)) {
          throw std::domain_error(
              fmt::format("the step size falls to {} at time {}, below {}", h_, t, smallest));
        }
      }
    }
  }

  const Eigen::MatrixXd& displacement() const { return q_; }
  const Eigen::MatrixXd& velocity() const { return v_; }
  Cost cost() const {
    const long long solving = operations_ + (solver_ ? solver_->operations() : 0);
    return {evaluations_, balance_.operations() + solving + 14 * evaluations_ * q_.size()};
  }

 private:
  /// The stages k_i = h f(y + sum_j a_ij k_j) + h J sum_{j <= i} c_ij k_j of y = (q, q') with
  /// c_ii = gamma. The rows of q are solved by hand, those of q' multiplied by M:
  ///   (M + gamma h C + (gamma h)^2 K) k_i = h (Q_i - C (...) - K (...)).
  /// Error over tolerance.
  double attempt(double t, double h) {
    set_step(h);
    std::array<Eigen::MatrixXd, 4> kq, kv;
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(q_.rows(), q_.cols());
    Eigen::MatrixXd error_q = zero, error_v = zero;
    new_q_ = q_;
    new_v_ = v_;
    for (std::size_t i = 0; i < 4; ++i) {
      Eigen::MatrixXd q = q_, v = v_, sum_q = zero, sum_v = zero;
      double time = t;
      for (std::size_t j = 0; j < i; ++j) {
        q += Ros34Pw2::a[i][j] * kq[j];
        v += Ros34Pw2::a[i][j] * kv[j];
        sum_q += Ros34Pw2::c[i][j] * kq[j];
        sum_v += Ros34Pw2::c[i][j] * kv[j];
        time += Ros34Pw2::a[i][j] * h;
      }
      const Eigen::MatrixXd without_own = h * (v + sum_v);
      const Eigen::MatrixXd force = balance_.load(time, q, v);
      kv[i] = i > 0 ? kv[i - 1] : zero;
      solver_->solve(h * balance_(force, q + sum_q + Ros34Pw2::gamma * without_own, v + sum_v),
                     kv[i]);
      kq[i] = without_own + Ros34Pw2::gamma * h * kv[i];
      new_q_ += Ros34Pw2::b[i] * kq[i];
      new_v_ += Ros34Pw2::b[i] * kv[i];
      error_q += (Ros34Pw2::b[i] - Ros34Pw2::embedded[i]) * kq[i];
      error_v += (Ros34Pw2::b[i] - Ros34Pw2::embedded[i]) * kv[i];
      ++evaluations_;
    }
    const double scale_q = q_.norm() + h * v_.norm();
    const double scale_v = v_.norm() + (new_v_ - v_).norm();
    const double error =
        std::max(relative(error_q.norm(), scale_q), relative(error_v.norm(), scale_v));
    return std::isnan(error) ? std::numeric_limits<double>::infinity() : error / tolerance_;
  }

  static double relative(double error, double scale) { return error == 0 ? 0 : error / scale; }

  void set_step(double h) {
    if (solver_ && h == solver_step_) return;
    if (solver_) operations_ += solver_->operations();
    const double g = Ros34Pw2::gamma * h;
    solver_step_ = h;
    solver_ = shifted_solver(system_, balance_.density() + g * balance_.gram_damping(),
                             g * balance_.stiffness_damping() + g * g, method_,
                             std::min(1e-6, 1e-3 * tolerance_));
  }

  const LagrangeSystem& system_;
  double tolerance_;
  LinearSolver method_;
  ResidualForce balance_;
  Eigen::MatrixXd q_, v_, new_q_, new_v_;
  double h_ = 0, solver_step_ = 0;
  std::unique_ptr<ShiftedSolver> solver_;
  long long evaluations_ = 0, operations_ = 0;
};

}  // namespace

Trajectory solve_rosenbrock(const InitialValueProblem& problem, double tolerance,
                            LinearSolver method) {
  check(problem);
  check_tolerance(tolerance);
  if (problem.system.material().density == 0) {
    throw std::domain_error(must_be("density", 0, "above 0 here"));
  }
  Rosenbrock state(problem, tolerance, method);
  Trajectory trajectory;
  keep_what_is_reached(trajectory, [&] {
    double time = 0;
    for (const double next : problem.times) {
      if (next > time) state.advance(time, next);
      time = next;
      trajectory.displacement.push_back(state.displacement());
      if (problem.with_velocities) trajectory.velocity.push_back(state.velocity());
      trajectory.cost = state.cost();
    }
  });
  return trajectory;
}

}  // namespace wavecurve::dynamics
