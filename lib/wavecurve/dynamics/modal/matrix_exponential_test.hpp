#pragma once

#include <stdexcept>
#include <unsupported/Eigen/MatrixFunctions>

#include <Eigen/Dense>

#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::dynamics::plain {

template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// The matrix A of one coordinate: unknowns (q, q', 1, cos_1, sin_1, ...), whose derivative is A times them.
template <class Scalar>
Matrix<Scalar> first_order_matrix(const InitialValueProblem& problem, Eigen::Index coordinate) {
  const LagrangeSystem& system = problem.system;
  const Force& force = problem.force;
  const Eigen::Index n = system.samples();
  const auto harmonics = static_cast<Eigen::Index>(force.harmonic.size());
  // Q = G f: the Gram matrix is the mass matrix over the density.
  const Matrix<Scalar> mass = Eigen::MatrixXd(system.mass()).cast<Scalar>();
  const Matrix<Scalar> gram = mass / Scalar(system.material().density);
  const auto acceleration = [&](const auto& q) { return mass.partialPivLu().solve(q).eval(); };

  Matrix<Scalar> a = Matrix<Scalar>::Zero(2 * n + 1 + 2 * harmonics, 2 * n + 1 + 2 * harmonics);
  a.block(0, n, n, n).setIdentity();
  a.block(n, 0, n, n) =
      -acceleration(Matrix<Scalar>(Eigen::MatrixXd(system.stiffness()).cast<Scalar>()));
  a.block(n, n, n, n) =
      -acceleration(Matrix<Scalar>(Eigen::MatrixXd(system.damping()).cast<Scalar>()));
  const auto density = [&](const Eigen::MatrixXd& f) {
    return acceleration(Matrix<Scalar>(gram * f.col(coordinate).cast<Scalar>()));
  };
  if (force.constant.size() > 0) a.block(n, 2 * n, n, 1) = density(force.constant);
  for (Eigen::Index h = 0; h < harmonics; ++h) {
    const HarmonicForce& harmonic = force.harmonic[static_cast<std::size_t>(h)];
    const Eigen::Index at = 2 * n + 1 + 2 * h;
    a.block(n, at, n, 1) = density(harmonic.cosine);
    a.block(n, at + 1, n, 1) = density(harmonic.sine);
    a(at, at + 1) = -Scalar(harmonic.omega);
    a(at + 1, at) = Scalar(harmonic.omega);
  }
  return a;
}

/// The plain twin of solve_spectral: the exponential of the dense first-order system (3.15), as it
/// should read, in the multiscale basis with M, C, K assembled, constant and harmonic forces as
/// further unknowns. O(samples^3) for each time. Scalar double or long double. Throws as
/// solve_spectral does.
template <class Scalar>
Trajectory solve_matrix_exponential(const InitialValueProblem& problem) {
  check(problem);
  if (problem.system.material().density == 0 || !problem.force.general.empty()) {
    throw std::domain_error("a density above 0 and no general force are needed");
  }
  const Eigen::Index n = problem.system.samples(),
                     coordinates = problem.initial_displacement.cols();
  const auto times = static_cast<std::size_t>(problem.times.size());
  Trajectory trajectory;
  trajectory.displacement.assign(times, Eigen::MatrixXd::Zero(n, coordinates));
  trajectory.velocity = trajectory.displacement;
  for (Eigen::Index j = 0; j < coordinates; ++j) {
    const Matrix<Scalar> a = first_order_matrix<Scalar>(problem, j);
    Matrix<Scalar> start = Matrix<Scalar>::Zero(a.rows(), 1);
    start.topRows(n) = problem.initial_displacement.col(j).cast<Scalar>();
    if (problem.initial_velocity.size() > 0)
      start.middleRows(n, n) = problem.initial_velocity.col(j).cast<Scalar>();
    start(2 * n) = 1;
    for (Eigen::Index h = 2 * n + 1; h < a.rows(); h += 2) start(h) = 1;
    for (std::size_t i = 0; i < times; ++i) {
      const Scalar t = problem.times[static_cast<Eigen::Index>(i)];
      const Matrix<Scalar> state = Matrix<Scalar>(a * t).exp() * start;
      trajectory.displacement[i].col(j) = state.topRows(n).template cast<double>();
      trajectory.velocity[i].col(j) = state.middleRows(n, n).template cast<double>();
    }
  }
  return trajectory;
}

}  // namespace wavecurve::dynamics::plain
