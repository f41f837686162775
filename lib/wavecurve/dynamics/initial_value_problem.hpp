#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/dynamics/lagrange_system.hpp"

namespace wavecurve::dynamics {

/// A force density per unit of the parameter interval as a function of time and state. It is given
/// the positions (rest shape and displacement) and velocities of the sample points, one a row, and
/// returns the density there, of the same shape. As everywhere, samples and finest-level
/// coefficients are identified.
using ForceDensity =
    std::function<Eigen::MatrixXd(double time, const Eigen::Ref<const Eigen::MatrixXd>& positions,
                                  const Eigen::Ref<const Eigen::MatrixXd>& velocities)>;

/// A density that oscillates, cosine cos(omega t) + sine sin(omega t); the two are given as
/// coefficients in the multiscale basis, samples x coordinates.
struct HarmonicForce {
  double omega = 0;
  Eigen::MatrixXd cosine = {}, sine = {};
};

/// The sum of all its parts; Q = G times the coefficients of the density.
struct Force {
  Eigen::MatrixXd constant = {};  ///< coefficients, samples x coordinates; no rows: none
  std::vector<HarmonicForce> harmonic = {};
  std::vector<ForceDensity> general = {};

  bool is_none() const { return constant.size() == 0 && harmonic.empty() && general.empty(); }
};

/// Gravity and the like: the same density everywhere, as Force::constant.
Eigen::MatrixXd uniform_density(const LagrangeSystem& system,
                                const Eigen::Ref<const Eigen::RowVectorXd>& density);

/// strength d / (|d|^2 + softening^2)^{3/2}, d from a point of the curve to the attracting one.
ForceDensity attraction(const Eigen::Ref<const Eigen::RowVectorXd>& point, double strength,
                        double softening);

/// The displacement u = u_p - u_0 and its velocity at time 0, and when they are wanted.
/// Coefficients in global-to-local order, samples x coordinates.
struct InitialValueProblem {
  LagrangeSystem system;
  Eigen::MatrixXd initial_displacement = {};
  Eigen::MatrixXd initial_velocity = {};  ///< no rows: at rest
  Eigen::VectorXd times = {};             ///< increasing, none negative
  Force force = {};
  Eigen::MatrixXd rest = {};    ///< u_0, seen by general forces only; no rows: zero
  bool with_velocities = true;  ///< whether the trajectory shall have them
};

/// What a solution has cost.
struct Cost {
  long long evaluations = 0;  ///< of the right-hand side, or solutions of a linear system
  long long operations = 0;   ///< additions and multiplications, counted by formula

  friend bool operator==(const Cost&, const Cost&) = default;
};

/// One state for each of the times. A massless curve has no velocity of its own; there it is that
/// of the equation, C^-1 (Q - K q).
struct Trajectory {
  std::vector<Eigen::MatrixXd> displacement, velocity;  ///< velocity: empty unless asked for
  Cost cost;
};

/// Thrown where a solver cannot go on: a force that throws or is not finite, a step size that
/// vanishes, an iteration that does not converge. The message names the time and the bound; the
/// states of the times before are kept.
class SolutionStopped : public std::runtime_error {
 public:
  SolutionStopped(const std::string& reason, Trajectory reached)
      : std::runtime_error(reason),
        reached_(std::make_shared<const Trajectory>(std::move(reached))) {}

  const Trajectory& reached() const { return *reached_; }

 private:
  std::shared_ptr<const Trajectory> reached_;  // shared: copying an exception must not throw
};

/// Runs steps, which appends states to the trajectory; what it throws becomes a SolutionStopped
/// with the states so far.
void keep_what_is_reached(Trajectory& trajectory, const std::function<void()>& steps);

/// Throws std::invalid_argument naming what does not fit: sizes, times that decrease or are
/// negative, values that are not finite. Every solver calls it first.
void check(const InitialValueProblem& problem);

}  // namespace wavecurve::dynamics
