#include "wavecurve/dynamics/stepping/massless.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/dynamics/detail/tolerance.hpp"
#include "wavecurve/dynamics/schulz_inverse.hpp"
#include "wavecurve/dynamics/stepping/detail/fixed_steps.hpp"
#include "wavecurve/dynamics/stepping/detail/residual_force.hpp"
#include "wavecurve/dynamics/stepping/detail/shifted_solver.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::dynamics {

namespace {

constexpr double schulz_residual = 1e-10;   ///< of C^-1, relative: below any Euler step's error
constexpr double schulz_threshold = 1e-14;  ///< entries of C^-1 dropped, relative to the largest

/// C^-1 as a product.
class SchulzSolver : public ShiftedSolver {
 public:
  explicit SchulzSolver(const Eigen::SparseMatrix<double>& c) {
    SchulzInverse<Eigen::SparseMatrix<double>> result =
        schulz_inverse(c, schulz_residual, schulz_threshold);
    if (result.status != SchulzStatus::converged) {
      throw std::domain_error(fmt::format(
          "Schulz' iteration for the damping matrix ends with the residual {}, but must reach {}{}",
          result.residuals.back(), schulz_residual,
          result.status == SchulzStatus::singular ? ": the matrix is singular" : ""));
    }
    inverse_ = std::move(result.inverse);
  }

  void solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x) override {
    x = inverse_ * b;
    operations_ += 2 * inverse_.nonZeros() * b.cols();
  }

 private:
  Eigen::SparseMatrix<double> inverse_;
};

/// One step of the theta method, (C + theta h K) (q_1 - q_0) = h (Q - K q_0): theta is 0, 1, 1/2.
class Massless {
 public:
  Massless(const InitialValueProblem& problem, MasslessMethod method)
      : system_(problem.system),
        method_(method),
        balance_(problem),
        q_(problem.initial_displacement) {
    velocity_ = Eigen::MatrixXd::Zero(q_.rows(), q_.cols());
    if (method == MasslessMethod::schulz_euler) {
      damping_ = std::make_unique<SchulzSolver>(system_.damping());
    } else {
      damping_ = factorised(0);
    }
  }

  void set_step(double h) {
    h_ = h;
    if (theta() > 0) implicit_ = factorised(theta() * h);
  }

  void step(double t) {
    const Eigen::MatrixXd now = balance_.load(t, q_, velocity_);
    if (theta() == 0) return take(now);
    const Eigen::MatrixXd next = balance_.load(t + h_, q_, velocity_);
    if (theta() == 1) return take(next);
    if (balance_.is_general()) {
      const Eigen::MatrixXd start = q_;
      take((now + next) / 2);
      const Eigen::MatrixXd predicted = q_;
      q_ = start;
      return take((now + balance_.load(t + h_, predicted, velocity_)) / 2);
    }
    take((now + next) / 2);
  }

  const Eigen::MatrixXd& displacement() const { return q_; }

  /// The velocity by the equation, C^-1 (Q - K q).
  Eigen::MatrixXd velocity(double t) {
    Eigen::MatrixXd result(q_.rows(), q_.cols());
    damping_->solve(unbalanced(balance_.load(t, q_, velocity_)), result);
    return result;
  }

  Cost cost() const {
    return {evaluations_, balance_.operations() + damping_->operations() +
                              (implicit_ ? implicit_->operations() : 0) +
                              4 * evaluations_ * q_.size()};
  }

 private:
  double theta() const {
    if (method_ == MasslessMethod::backward_euler) return 1;
    return method_ == MasslessMethod::crank_nicolson ? 0.5 : 0;
  }

  std::unique_ptr<ShiftedSolver> factorised(double stiffness) const {
    return shifted_solver(system_, balance_.gram_damping(),
                          balance_.stiffness_damping() + stiffness, LinearSolver::factorisation, 0);
  }

  Eigen::MatrixXd unbalanced(const Eigen::MatrixXd& load) {
    return balance_(load, q_, Eigen::MatrixXd::Zero(q_.rows(), q_.cols()));
  }

  void take(const Eigen::MatrixXd& load) {
    Eigen::MatrixXd rate(q_.rows(), q_.cols());
    (theta() > 0 ? implicit_ : damping_)->solve(unbalanced(load), rate);
    q_ += h_ * rate;
    velocity_ = std::move(rate);
    ++evaluations_;
  }

  const LagrangeSystem& system_;
  MasslessMethod method_;
  ResidualForce balance_;
  Eigen::MatrixXd q_, velocity_;
  double h_ = 0;
  std::unique_ptr<ShiftedSolver> damping_, implicit_;
  long long evaluations_ = 0;
};

void check_regular(const LagrangeSystem& system) {
  const CirculantEigenvalues symbols = system.eigenvalues();
  Eigen::Index frequency = 0;
  const double smallest = symbols.damping.minCoeff(&frequency);
  if (smallest > 0) return;
  throw std::domain_error(fmt::format(
      "the damping matrix C is singular: its eigenvalue at frequency {} is {}, but must "
      "be above 0; a damping density above 0 makes it so",
      frequency, smallest));
}

}  // namespace

double stability_bound(const LagrangeSystem& system) {
  const CirculantEigenvalues symbols = system.eigenvalues();
  const double largest = (symbols.stiffness.array() / symbols.damping.array()).maxCoeff();
  return largest > 0 ? 2 / largest : std::numeric_limits<double>::infinity();
}

Trajectory solve_massless(const InitialValueProblem& problem, MasslessMethod method, double step,
                          bool is_forced) {
  check(problem);
  check_step(step);
  if (problem.system.material().density != 0) {
    throw std::domain_error(
        must_be("density", problem.system.material().density, "0 for the massless equation"));
  }
  check_regular(problem.system);
  const bool is_explicit =
      method == MasslessMethod::schulz_euler || method == MasslessMethod::explicit_euler;
  const double bound = stability_bound(problem.system);
  if (is_explicit && step > bound && !is_forced) {
    throw std::domain_error(fmt::format(
        "step is {}, but explicit Euler is stable up to {} only, 2 / the largest eigenvalue of "
        "C^-1 K",
        step, bound));
  }
  return in_fixed_steps(problem, step, [&] { return Massless(problem, method); });
}

}  // namespace wavecurve::dynamics
