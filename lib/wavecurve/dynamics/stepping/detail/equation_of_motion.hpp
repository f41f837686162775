#pragma once

#include <optional>

#include <Eigen/Core>

#include "wavecurve/dynamics/detail/force_coefficients.hpp"
#include "wavecurve/dynamics/stepping/detail/system_operator.hpp"

namespace wavecurve::dynamics {

/// The acceleration, M^-1 (Q - C q' - K q), as a function of time and state. Matrix-free,
///   q'' = (f - damping_density q' - G^-1 K (q + stiffness_damping q')) / density - mass_damping
///   q',
/// f the coefficients of the force density: G drops out of all but the stiffness. Or, as the plain
/// twin, with the dense matrices M^-1 C and M^-1 K.
class EquationOfMotion {
 public:
  /// Throws std::domain_error if the density is 0.
  EquationOfMotion(const InitialValueProblem& problem, bool dense);

  void operator()(double time, const Eigen::Ref<const Eigen::MatrixXd>& displacement,
                  const Eigen::Ref<const Eigen::MatrixXd>& velocity,
                  Eigen::Ref<Eigen::MatrixXd> acceleration);

  const Cost& cost() const { return cost_; }

 private:
  Material material_;
  ForceCoefficients force_;
  std::optional<ReducedStiffness> stiffness_;        ///< matrix-free
  Eigen::MatrixXd dense_damping_, dense_stiffness_;  ///< M^-1 C, M^-1 K
  Eigen::MatrixXd combined_;                         ///< q + s_2 q'
  Cost cost_;
};

}  // namespace wavecurve::dynamics
