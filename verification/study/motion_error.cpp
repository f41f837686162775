#include "verification/study/motion_error.hpp"

#include <algorithm>
#include <cmath>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

namespace wavecurve::verification {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

double square(const Matrix& form, const MatrixXd& e) { return e.cwiseProduct(form * e).sum(); }

Matrix gram_of(const dynamics::LagrangeSystem& system) {
  return gram(system.bank(), system.samples(), system.levels());
}

/// Twice the energy of the initial state.
double initial_square(const dynamics::InitialValueProblem& problem, const Matrix& mass,
                      const Matrix& stiffness) {
  double sum = square(stiffness, problem.initial_displacement);
  if (problem.initial_velocity.size() > 0) sum += square(mass, problem.initial_velocity);
  return sum;
}

double largest_distance(const dynamics::LagrangeSystem& system, const MatrixXd& coefficients) {
  return to_samples(system.bank(), coefficients, system.levels()).rowwise().norm().maxCoeff();
}

}  // namespace

VectorXd displacement_errors(const dynamics::InitialValueProblem& problem,
                             const dynamics::Trajectory& solution,
                             const dynamics::Trajectory& exact) {
  const Matrix form = gram_of(problem.system);
  const double unit = square(form, problem.initial_displacement);
  VectorXd errors(problem.times.size());
  for (std::size_t i = 0; i < exact.displacement.size(); ++i) {
    const MatrixXd e = solution.displacement.at(i) - exact.displacement[i];
    errors[static_cast<Index>(i)] = std::sqrt(square(form, e) / unit);
  }
  return errors;
}

VectorXd maximum_errors(const dynamics::InitialValueProblem& problem,
                        const dynamics::Trajectory& solution, const dynamics::Trajectory& exact) {
  const double unit = largest_distance(problem.system, problem.initial_displacement);
  VectorXd errors(problem.times.size());
  for (std::size_t i = 0; i < exact.displacement.size(); ++i) {
    const MatrixXd e = solution.displacement.at(i) - exact.displacement[i];
    errors[static_cast<Index>(i)] = largest_distance(problem.system, e) / unit;
  }
  return errors;
}

VectorXd velocity_errors(const dynamics::InitialValueProblem& problem,
                         const dynamics::Trajectory& solution, const dynamics::Trajectory& exact) {
  const Matrix form = gram_of(problem.system);
  VectorXd errors(problem.times.size());
  double unit = 0;
  for (std::size_t i = 0; i < exact.velocity.size(); ++i) {
    const MatrixXd e = solution.velocity.at(i) - exact.velocity[i];
    errors[static_cast<Index>(i)] = std::sqrt(square(form, e));
    unit = std::max(unit, std::sqrt(square(form, exact.velocity[i])));
  }
  return errors / unit;
}

VectorXd energy_errors(const dynamics::InitialValueProblem& problem,
                       const dynamics::Trajectory& solution, const dynamics::Trajectory& exact) {
  const Matrix mass = problem.system.mass(), stiffness = problem.system.stiffness();
  const double unit = initial_square(problem, mass, stiffness);
  VectorXd errors(problem.times.size());
  for (std::size_t i = 0; i < exact.displacement.size(); ++i) {
    const MatrixXd e = solution.displacement.at(i) - exact.displacement[i];
    const MatrixXd v = solution.velocity.at(i) - exact.velocity[i];
    errors[static_cast<Index>(i)] = std::sqrt((square(mass, v) + square(stiffness, e)) / unit);
  }
  return errors;
}

VectorXd energies(const dynamics::InitialValueProblem& problem,
                  const dynamics::Trajectory& solution) {
  const Matrix mass = problem.system.mass(), stiffness = problem.system.stiffness();
  const double unit = initial_square(problem, mass, stiffness);
  VectorXd energy(problem.times.size());
  for (std::size_t i = 0; i < solution.displacement.size(); ++i) {
    energy[static_cast<Index>(i)] =
        (square(mass, solution.velocity.at(i)) + square(stiffness, solution.displacement[i])) /
        unit;
  }
  return energy;
}

double energy_drift(const dynamics::InitialValueProblem& problem,
                    const dynamics::Trajectory& solution) {
  const dynamics::Material& material = problem.system.material();
  const VectorXd energy = energies(problem, solution);
  const bool is_damped =
      material.mass_damping > 0 || material.stiffness_damping > 0 || material.damping_density > 0;
  if (!is_damped) return (energy.array() - 1).abs().maxCoeff();
  double last = 1, largest = 0;
  for (const double now : energy) {
    largest = std::max(largest, now - last);
    last = now;
  }
  return largest;
}

}  // namespace wavecurve::verification
