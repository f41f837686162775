#include "wavecurve/dynamics/modal/detail/modal_solution.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/dynamics/modal/detail/exponential_integrator.hpp"
#include "wavecurve/dynamics/modal/detail/modal_propagator.hpp"

namespace wavecurve::dynamics {

namespace {

/// Whether times[j] = j dt for all j, up to rounding; of at least two times.
bool is_equally_spaced(const Eigen::VectorXd& times) {
  const Eigen::Index last = times.size() - 1;
  if (last < 1) return false;
  const double step = times[last] / static_cast<double>(last);
  for (Eigen::Index j = 0; j <= last; ++j) {
    // Equal but for the rounding of a product and of a division.
    const double time = static_cast<double>(j) * step;
    if (std::abs(times[j] - time) > 4 * std::numeric_limits<double>::epsilon() * time) return false;
  }
  return true;
}

/// The states at the problem's times, for the start and a constant force. For equally spaced times
/// j dt, j = large b + small with b about the root of their number, only the propagators over dt
/// and over b dt are computed from the closed form, the others are their powers.
class ModalFlow {
 public:
  ModalFlow(const InitialValueProblem& problem, const ModalBasis& basis, ModalState start,
            ModalCoefficients force)
      : basis_(basis),
        times_(problem.times),
        velocities_(problem.with_velocities),
        force_(std::move(force)),
        state_(std::move(start)) {
    if (times_.size() < 4 || !is_equally_spaced(times_)) return;
    const double step = times_[times_.size() - 1] / static_cast<double>(times_.size() - 1);
    while (block_ * block_ < times_.size()) ++block_;
    small_.emplace_back(basis_.modes(), 0.0);
    small_.emplace_back(basis_.modes(), step);
    while (static_cast<Eigen::Index>(small_.size()) < block_) {
      small_.push_back(small_.back().then(small_[1]));
    }
    large_ = ModalPropagator(basis_.modes(), static_cast<double>(block_) * step);
  }

  /// To be called for j = 0, 1, ... in order.
  ModalState at(Eigen::Index j) {
    if (small_.empty()) {
      const bool is_simple = !velocities_ && state_.velocity.size() == 0 && force_.size() == 0;
      const ModalPropagator propagator(basis_.modes(), times_[j], is_simple);
      const bool is_last = j + 1 == times_.size();  // the start is not needed any more
      if (!is_last) return propagator.advance(basis_, state_, force_, velocities_);
      return propagator.advance(basis_, std::move(state_.displacement), state_.velocity, force_,
                                velocities_);
    }
    if (j > 0 && j % block_ == 0) state_ = large_.advance(basis_, state_, force_, true);
    return small_[static_cast<std::size_t>(j % block_)].advance(basis_, state_, force_,
                                                                velocities_);
  }

 private:
  const ModalBasis& basis_;
  Eigen::VectorXd times_;
  bool velocities_;
  ModalCoefficients force_;
  ModalState state_;  ///< at the start; of equally spaced times, at that of the block
  Eigen::Index block_ = 1;
  std::vector<ModalPropagator> small_;
  ModalPropagator large_;
};

/// Q = G times the density.
ModalCoefficients weighted(const ModalBasis& basis, ModalCoefficients density) {
  for (Eigen::Index k = 0; k < density.rows(); ++k) {
    density.row(k) *= basis.modes().gram[basis.mode(k)];
  }
  return density;
}

void add_harmonic(ModalState& state, const ModalBasis& basis, const ModalCoefficients& cosine,
                  const ModalCoefficients& sine, double omega, double t) {
  std::vector<HarmonicResponse> responses;
  for (Eigen::Index n = 0; n < basis.modes().mass.size(); ++n) {
    responses.push_back(harmonic_response(oscillator(basis.modes(), n), omega, t));
  }
  for (Eigen::Index j = 0; j < cosine.cols(); ++j) {
    for (Eigen::Index k = 0; k < cosine.rows(); ++k) {
      const HarmonicResponse& r = responses[static_cast<std::size_t>(basis.mode(k))];
      state.displacement(k, j) += r.q.real() * cosine(k, j) + r.q.imag() * sine(k, j);
      if (state.velocity.size() == 0) continue;
      state.velocity(k, j) += r.v.real() * cosine(k, j) + r.v.imag() * sine(k, j);
    }
  }
}

void check_solvable(const InitialValueProblem& problem, const CirculantEigenvalues& modes) {
  check(problem);
  for (Eigen::Index n = 0; n < modes.mass.size(); ++n) {
    if (modes.mass[n] > 0 || modes.damping[n] > 0) continue;
    throw std::domain_error(
        fmt::format("density is {}, and the damping of mode {} is {}: C is singular, but one of "
                    "the two must be above 0; a damping density above 0 makes it so",
                    modes.mass[n], n, modes.damping[n]));
  }
}

}  // namespace

Trajectory solve_modes(const InitialValueProblem& problem, ModalBasis& basis, double tolerance) {
  check_solvable(problem, basis.modes());
  if (!problem.force.general.empty()) return integrate_exponentially(problem, basis, tolerance);
  const Force& force = problem.force;
  const Eigen::Index coordinates = problem.initial_displacement.cols();
  const auto spectrum = [&](const Eigen::MatrixXd& coefficients) {
    return coefficients.size() > 0 ? basis.forward(coefficients) : ModalCoefficients();
  };
  std::vector<std::pair<ModalCoefficients, ModalCoefficients>> harmonic;
  for (const HarmonicForce& part : force.harmonic) {
    harmonic.emplace_back(weighted(basis, spectrum(part.cosine)),
                          weighted(basis, spectrum(part.sine)));
  }
  ModalFlow flow(problem, basis,
                 {spectrum(problem.initial_displacement), spectrum(problem.initial_velocity)},
                 weighted(basis, spectrum(force.constant)));
  Trajectory trajectory;
  for (Eigen::Index i = 0; i < problem.times.size(); ++i) {
    ModalState state = flow.at(i);
    for (std::size_t h = 0; h < harmonic.size(); ++h) {
      add_harmonic(state, basis, harmonic[h].first, harmonic[h].second, force.harmonic[h].omega,
                   problem.times[i]);
    }
    trajectory.displacement.push_back(basis.backward(std::move(state.displacement), coordinates));
    if (!problem.with_velocities) continue;
    trajectory.velocity.push_back(basis.backward(std::move(state.velocity), coordinates));
  }
  // Each state is two or four products with complex numbers a row, and a change of basis.
  const long long columns = (coordinates + 1) / 2, parts = problem.with_velocities ? 2 : 1;
  trajectory.cost.operations =
      columns * parts * (problem.times.size() + 1) * (basis.operations() + 8 * basis.rows());
  return trajectory;
}

}  // namespace wavecurve::dynamics
