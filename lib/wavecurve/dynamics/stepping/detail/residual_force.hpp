#pragma once

#include <optional>

#include <Eigen/Core>

#include "wavecurve/dynamics/detail/force_coefficients.hpp"
#include "wavecurve/dynamics/stepping/detail/system_operator.hpp"

namespace wavecurve::dynamics {

/// What is left of the forces, Q - C q' - K q = G (f - c q') - K (q + s_2 q') with
/// C = c G + s_2 K, c = damping_density + mass_damping density: M q'' for the implicit methods.
class ResidualForce {
 public:
  explicit ResidualForce(const InitialValueProblem& problem);

  double density() const { return material_.density; }
  /// C = gram_damping() G + stiffness_damping() K.
  double gram_damping() const;
  double stiffness_damping() const { return material_.stiffness_damping; }

  /// f, the coefficients of the force density, see ForceCoefficients.
  Eigen::MatrixXd load(double time, const Eigen::Ref<const Eigen::MatrixXd>& displacement,
                       const Eigen::Ref<const Eigen::MatrixXd>& velocity);
  bool is_general() const { return force_.is_general(); }

  Eigen::MatrixXd operator()(const Eigen::Ref<const Eigen::MatrixXd>& load,
                             const Eigen::Ref<const Eigen::MatrixXd>& displacement,
                             const Eigen::Ref<const Eigen::MatrixXd>& velocity);
  long long operations() const { return operations_; }  ///< so far

 private:
  Material material_;
  ForceCoefficients force_;
  std::optional<SystemOperator> gram_;  ///< none where G = I
  SystemOperator stiffness_;
  Eigen::MatrixXd product_;
  long long operations_ = 0;
};

}  // namespace wavecurve::dynamics
