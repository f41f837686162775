#include "motion_error.hpp"

#include <cmath>

#include "wavecurve/operators/multiscale_matrix.hpp"

namespace wavecurve::verification {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

double square(const Matrix& form, const MatrixXd& e) { return e.cwiseProduct(form * e).sum(); }

}  // namespace

VectorXd displacement_errors(const InitialValueProblem& problem, const Trajectory& solution,
                             const Trajectory& exact) {
  const LagrangeSystem& system = problem.system;
  const Matrix form = gram(system.bank(), system.samples(), system.levels());
  const double unit = square(form, problem.displacement);
  VectorXd errors(problem.times.size());
  for (std::size_t i = 0; i < exact.displacement.size(); ++i) {
    const MatrixXd e = solution.displacement.at(i) - exact.displacement[i];
    errors[static_cast<Eigen::Index>(i)] = std::sqrt(square(form, e) / unit);
  }
  return errors;
}

VectorXd energy_errors(const InitialValueProblem& problem, const Trajectory& solution,
                       const Trajectory& exact) {
  const Matrix mass = problem.system.mass(), stiffness = problem.system.stiffness();
  double unit = square(stiffness, problem.displacement);
  if (problem.velocity.size() > 0) unit += square(mass, problem.velocity);
  VectorXd errors(problem.times.size());
  for (std::size_t i = 0; i < exact.displacement.size(); ++i) {
    const MatrixXd e = solution.displacement.at(i) - exact.displacement[i];
    const MatrixXd v = solution.velocity.at(i) - exact.velocity[i];
    errors[static_cast<Eigen::Index>(i)] =
        std::sqrt((square(mass, v) + square(stiffness, e)) / unit);
  }
  return errors;
}

}  // namespace wavecurve::verification
