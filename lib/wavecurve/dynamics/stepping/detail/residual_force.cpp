#include "wavecurve/dynamics/stepping/detail/residual_force.hpp"

namespace wavecurve::dynamics {

ResidualForce::ResidualForce(const InitialValueProblem& problem)
    : material_(problem.system.material()), force_(problem), stiffness_(problem.system, 0, 1) {
  if (!problem.system.bank().is_orthonormal()) gram_.emplace(problem.system, 1, 0);
}

double ResidualForce::gram_damping() const {
  return material_.damping_density + material_.mass_damping * material_.density;
}

Eigen::MatrixXd ResidualForce::load(double time,
                                    const Eigen::Ref<const Eigen::MatrixXd>& displacement,
                                    const Eigen::Ref<const Eigen::MatrixXd>& velocity) {
  return force_(time, displacement, velocity);
}

Eigen::MatrixXd ResidualForce::operator()(const Eigen::Ref<const Eigen::MatrixXd>& load,
                                          const Eigen::Ref<const Eigen::MatrixXd>& displacement,
                                          const Eigen::Ref<const Eigen::MatrixXd>& velocity) {
  Eigen::MatrixXd result = load - gram_damping() * velocity;
  product_.resize(result.rows(), result.cols());
  if (gram_) {
    gram_->apply(result, product_);
    result = product_;
    operations_ += result.cols() * gram_->operations();
  }
  stiffness_.apply(displacement + stiffness_damping() * velocity, product_);
  operations_ += result.cols() * (stiffness_.operations() + 6 * result.rows());
  return result - product_;
}

}  // namespace wavecurve::dynamics
