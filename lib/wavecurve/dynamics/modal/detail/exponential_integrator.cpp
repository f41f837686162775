#include "wavecurve/dynamics/modal/detail/exponential_integrator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/dynamics/detail/force_coefficients.hpp"
#include "wavecurve/dynamics/detail/tolerance.hpp"
#include "wavecurve/dynamics/modal/detail/modal_propagator.hpp"

namespace wavecurve::dynamics {

namespace {

constexpr int deepest = 40;  ///< halvings of the distance between two times

/// phi_1, phi_2, phi_3 of a step, by mode: what forces 1, s, s^2 / 2 add to q and q'.
struct Responses {
  std::array<Eigen::ArrayXd, 3> q, v;

  Responses(const CirculantEigenvalues& modes, double h) {
    for (std::size_t k = 0; k < 3; ++k)
      q[k].resize(modes.mass.size()), v[k].resize(modes.mass.size());
    for (Eigen::Index n = 0; n < modes.mass.size(); ++n) {
      const RampResponse response = ramp_response(oscillator(modes, n), h);
      for (std::size_t k = 0; k < 3; ++k) {
        q[k][n] = response.q[k];
        v[k][n] = response.v[k];
      }
    }
  }
};

/// Weights of phi_1, phi_2, phi_3.
using Weights = std::array<double, 3>;

class Integrator {
 public:
  Integrator(const InitialValueProblem& problem, ModalBasis& basis)
      : basis_(basis), force_(problem), coordinates_(problem.initial_displacement.cols()) {}

  /// Q at a time and state.
  ModalCoefficients force(double t, const ModalState& state) {
    ++cost_.evaluations;
    const Eigen::MatrixXd q = basis_.backward(state.displacement, coordinates_);
    const Eigen::MatrixXd v = basis_.backward(state.velocity, coordinates_);
    ModalCoefficients density = basis_.forward(force_(t, q, v));
    for (Eigen::Index k = 0; k < density.rows(); ++k) {
      density.row(k) *= basis_.modes().gram[basis_.mode(k)];
    }
    cost_.operations += 3 * basis_.operations() * density.cols();
    return density;
  }

  /// Krogstad's step; force is that at t.
  ModalState step(double t, double h, const ModalState& start, const ModalCoefficients& force1) {
    const Table &half = table(h / 2), &full = table(h);
    ModalState stage = advance(half, start, {{&force1, {1, 0, 0}}});
    const ModalCoefficients force2 = force(t + h / 2, stage);
    // In units of the half step: h phi_2(h / 2) = 2 (h / 2) phi_2.
    stage = advance(half, start, {{&force1, {1, -2, 0}}, {&force2, {0, 2, 0}}});
    const ModalCoefficients force3 = force(t + h / 2, stage);
    stage = advance(full, start, {{&force1, {1, -2, 0}}, {&force3, {0, 2, 0}}});
    const ModalCoefficients force4 = force(t + h, stage);
    const ModalCoefficients middle = force2 + force3;
    return advance(full, start,
                   {{&force1, {1, -3, 4}}, {&middle, {0, 2, -4}}, {&force4, {0, -1, 4}}});
  }

  /// A massless curve's velocity follows from its displacement and the force.
  ModalState with_velocity(ModalState state, const ModalCoefficients& force) const {
    const CirculantEigenvalues& modes = basis_.modes();
    if (!is_massless()) return state;
    for (Eigen::Index k = 0; k < force.rows(); ++k) {
      const Eigen::Index n = basis_.mode(k);
      state.velocity.row(k) =
          (force.row(k) - modes.stiffness[n] * state.displacement.row(k)) / modes.damping[n];
    }
    return state;
  }

  ModalCoefficients acceleration(const ModalState& state, const ModalCoefficients& force) const {
    const CirculantEigenvalues& modes = basis_.modes();
    ModalCoefficients result = ModalCoefficients::Zero(force.rows(), force.cols());
    if (is_massless()) return result;
    for (Eigen::Index k = 0; k < force.rows(); ++k) {
      const Eigen::Index n = basis_.mode(k);
      result.row(k) = (force.row(k) - modes.stiffness[n] * state.displacement.row(k) -
                       modes.damping[n] * state.velocity.row(k)) /
                      modes.mass[n];
    }
    return result;
  }

  void forget_tables() { tables_.clear(); }
  const Cost& cost() const { return cost_; }
  const ModalBasis& basis() const { return basis_; }

 private:
  bool is_massless() const { return basis_.modes().mass[0] == 0; }

  struct Table {
    ModalPropagator propagator;
    Responses responses;
  };

  const Table& table(double h) {
    const auto found = tables_.find(h);
    if (found != tables_.end()) return found->second;
    const CirculantEigenvalues& modes = basis_.modes();
    return tables_.emplace(h, Table{ModalPropagator(modes, h), Responses(modes, h)}).first->second;
  }

  struct Term {
    const ModalCoefficients* force;
    Weights weights;
  };

  ModalState advance(const Table& over, const ModalState& start, const std::vector<Term>& terms) {
    ModalState state = over.propagator.advance(basis_, start, {}, true);
    for (const Term& term : terms) {
      const Weights& w = term.weights;
      const Responses& r = over.responses;
      const Eigen::ArrayXd q = w[0] * r.q[0] + w[1] * r.q[1] + w[2] * r.q[2];
      const Eigen::ArrayXd v = w[0] * r.v[0] + w[1] * r.v[1] + w[2] * r.v[2];
      for (Eigen::Index j = 0; j < state.displacement.cols(); ++j) {
        for (Eigen::Index k = 0; k < state.displacement.rows(); ++k) {
          const Eigen::Index n = basis_.mode(k);
          state.displacement(k, j) += q[n] * (*term.force)(k, j);
          state.velocity(k, j) += v[n] * (*term.force)(k, j);
        }
      }
      cost_.operations += 8 * state.displacement.size();
    }
    if (is_massless()) state.velocity = start.velocity;  // until with_velocity
    return state;
  }

  ModalBasis& basis_;
  ForceCoefficients force_;
  Eigen::Index coordinates_;
  std::map<double, Table> tables_;  ///< by step
  Cost cost_;
};

/// From one time to the next in steps of (distance / 2^depth), each aligned to its own size.
class DyadicSteps {
 public:
  DyadicSteps(Integrator& integrator, double tolerance, ModalState start, double time)
      : integrator_(integrator), tolerance_(tolerance), state_(std::move(start)) {
    force_ = integrator_.force(time, state_);
    state_ = integrator_.with_velocity(std::move(state_), force_);
  }

  const ModalState& state() const { return state_; }

  void advance(double from, double to) {
    if (std::abs((to - from) / distance_ - 1) > 1e-13) {
      if (distance_ > 0) {
        int doublings;  // that make the old distance at least the new one
        if (std::frexp((to - from) / distance_, &doublings) == 0.5) --doublings;
        depth_ += doublings;
      }
      depth_ = std::clamp(depth_, 0, deepest);
      distance_ = to - from;
      integrator_.forget_tables();
    }
    long long at = 0;  // in units of distance / 2^depth
    while (at < (1LL << depth_)) {
      const double h = std::ldexp(distance_, -depth_);
      const double error = attempt(from + static_cast<double>(at) * h, h);
      if (!(error <= 1)) {
        if (++depth_ > deepest) throw_underflow(from + static_cast<double>(at) * h);
        at *= 2;
        continue;
      }
      ++at;
      // Twice the step has 32 times the error.
      if (error < 1.0 / 64 && depth_ > 0 && at % 2 == 0) {
        --depth_;
        at /= 2;
      }
    }
  }

 private:
  /// The step's error over the tolerance; it is taken if that is at most 1.
  double attempt(double t, double h) {
    const ModalState coarse = integrator_.step(t, h, state_, force_);
    ModalState fine = integrator_.step(t, h / 2, state_, force_);
    const ModalCoefficients middle = integrator_.force(t + h / 2, fine);
    fine = integrator_.step(t + h / 2, h / 2, fine, middle);
    const ModalCoefficients force = integrator_.force(t + h, fine);
    const ModalCoefficients acceleration = integrator_.acceleration(fine, force);
    displacement_ = std::max(displacement_, fine.displacement.norm() + h * fine.velocity.norm());
    velocity_ = std::max(velocity_, fine.velocity.norm() + h * acceleration.norm());
    const double error_q = (fine.displacement - coarse.displacement).norm();
    const double error_v = (fine.velocity - coarse.velocity).norm();
    const double error = std::max(relative(error_q, displacement_), relative(error_v, velocity_)) /
                         (15 * tolerance_);
    if (error <= 1) {
      state_ = integrator_.with_velocity(std::move(fine), force);
      force_ = force;
    }
    return error;
  }

  static double relative(double error, double scale) { return error == 0 ? 0 : error / scale; }

  void throw_underflow(double t) const {
    throw std::domain_error(
        fmt::format("the step size is below {} at time {}: tolerance {} cannot be reached there",
                    std::ldexp(distance_, -deepest), t, tolerance_));
  }

  Integrator& integrator_;
  double tolerance_;
  ModalState state_;
  ModalCoefficients force_;
  double distance_ = 0, displacement_ = 0,
         velocity_ = 0;  ///< the norms that errors are relative to
  int depth_ = 0;
};

}  // namespace

Trajectory integrate_exponentially(const InitialValueProblem& problem, ModalBasis& basis,
                                   double tolerance) {
  check_tolerance(tolerance);
  const Eigen::Index coordinates = problem.initial_displacement.cols();
  ModalState start = {basis.forward(problem.initial_displacement), {}};
  start.velocity = problem.initial_velocity.size() > 0
                       ? basis.forward(problem.initial_velocity)
                       : ModalCoefficients::Zero(basis.rows(), start.displacement.cols());
  Integrator integrator(problem, basis);
  Trajectory trajectory;
  keep_what_is_reached(trajectory, [&] {
    DyadicSteps steps(integrator, tolerance, std::move(start), 0);
    double time = 0;
    for (const double next : problem.times) {
      if (next > time) steps.advance(time, next);
      time = next;
      trajectory.displacement.push_back(basis.backward(steps.state().displacement, coordinates));
      if (problem.with_velocities) {
        trajectory.velocity.push_back(basis.backward(steps.state().velocity, coordinates));
      }
      trajectory.cost = integrator.cost();
    }
  });
  return trajectory;
}

}  // namespace wavecurve::dynamics
