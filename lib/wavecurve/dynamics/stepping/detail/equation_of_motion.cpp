#include "wavecurve/dynamics/stepping/detail/equation_of_motion.hpp"

#include <stdexcept>

#include <Eigen/Cholesky>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::dynamics {

EquationOfMotion::EquationOfMotion(const InitialValueProblem& problem, bool dense)
    : material_(problem.system.material()), force_(problem) {
  if (material_.density == 0) {
    throw std::domain_error(
        must_be("density", 0, "above 0 here; the massless equation has solvers of its own"));
  }
  if (!dense) {
    stiffness_.emplace(problem.system);
    return;
  }
  const Eigen::LLT<Eigen::MatrixXd> mass{Eigen::MatrixXd(problem.system.mass())};
  dense_damping_ = mass.solve(Eigen::MatrixXd(problem.system.damping()));
  dense_stiffness_ = mass.solve(Eigen::MatrixXd(problem.system.stiffness()));
}

void EquationOfMotion::operator()(double time,
                                  const Eigen::Ref<const Eigen::MatrixXd>& displacement,
                                  const Eigen::Ref<const Eigen::MatrixXd>& velocity,
                                  Eigen::Ref<Eigen::MatrixXd> acceleration) {
  ++cost_.evaluations;
  const long long n = displacement.rows(), columns = displacement.cols();
  if (stiffness_) {
    const double uniform = material_.damping_density / material_.density + material_.mass_damping;
    combined_ = displacement;
    if (material_.stiffness_damping > 0) combined_ += material_.stiffness_damping * velocity;
    stiffness_->apply(combined_, acceleration);
    acceleration *= -1 / material_.density;
    if (uniform > 0) acceleration -= uniform * velocity;
    cost_.operations += columns * (stiffness_->operations() + 5 * n);
  } else {
    acceleration.noalias() = -dense_stiffness_ * displacement;
    acceleration.noalias() -= dense_damping_ * velocity;
    cost_.operations += columns * 4 * n * n;
  }
  if (!force_.is_none()) {
    acceleration += force_(time, displacement, velocity) / material_.density;
    cost_.operations += 2 * n * columns;
  }
}

}  // namespace wavecurve::dynamics
