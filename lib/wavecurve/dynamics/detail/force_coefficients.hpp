#pragma once

#include <Eigen/Core>

#include "wavecurve/dynamics/initial_value_problem.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve::dynamics {

/// The force density of a problem as coefficients in the multiscale basis, samples x coordinates,
/// at any time and state: the sum of its constant, harmonic and general parts. Q = G times it.
class ForceCoefficients {
 public:
  explicit ForceCoefficients(const InitialValueProblem& problem);

  bool is_none() const { return force_.is_none(); }
  /// Whether it depends on the state, as general forces may.
  bool is_general() const { return !force_.general.empty(); }

  /// Throws std::domain_error naming the force and the time if a general force throws, is not
  /// finite or has another shape than its input.
  Eigen::MatrixXd operator()(double time, const Eigen::Ref<const Eigen::MatrixXd>& displacement,
                             const Eigen::Ref<const Eigen::MatrixXd>& velocity);

 private:
  Eigen::MatrixXd at_samples(const Eigen::Ref<const Eigen::MatrixXd>& coefficients);
  Eigen::MatrixXd general(std::size_t index, double time, const Eigen::MatrixXd& positions,
                          const Eigen::MatrixXd& velocities) const;

  Force force_;
  PeriodicTransform<double> transform_;
  Eigen::VectorXd workspace_;
  Eigen::MatrixXd rest_;  ///< u_0 at the samples
};

}  // namespace wavecurve::dynamics
