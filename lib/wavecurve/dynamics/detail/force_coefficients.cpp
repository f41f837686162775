#include "wavecurve/dynamics/detail/force_coefficients.hpp"

#include <cmath>
#include <new>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/elementary/sine_cosine.hpp"

namespace wavecurve::dynamics {

ForceCoefficients::ForceCoefficients(const InitialValueProblem& problem)
    : force_(problem.force),
      transform_(problem.system.bank(), problem.system.samples(), problem.system.levels()),
      workspace_(transform_.workspace_size()) {
  if (is_general() && problem.rest.size() > 0) rest_ = at_samples(problem.rest);
}

Eigen::MatrixXd ForceCoefficients::at_samples(
    const Eigen::Ref<const Eigen::MatrixXd>& coefficients) {
  Eigen::MatrixXd samples(coefficients.rows(), coefficients.cols());
  for (Eigen::Index j = 0; j < samples.cols(); ++j) {
    transform_.inverse(coefficients.col(j), samples.col(j), workspace_);
  }
  return samples;
}

Eigen::MatrixXd ForceCoefficients::general(std::size_t index, double time,
                                           const Eigen::MatrixXd& positions,
                                           const Eigen::MatrixXd& velocities) const {
  const auto fail = [&](const std::string& what) -> std::domain_error {
    return std::domain_error(fmt::format("general force {} {} at time {}", index, what, time));
  };
  Eigen::MatrixXd density;
  try {
    density = force_.general[index](time, positions, velocities);
  } catch (const std::bad_alloc&) {  // what the machine lacks says nothing about the solution
    throw;
  } catch (const std::exception& failure) {
    throw fail(fmt::format("throws \"{}\"", failure.what()));
  }
  if (density.rows() != positions.rows() || density.cols() != positions.cols()) {
    throw fail(fmt::format("is {} x {}, but must be {} x {}", density.rows(), density.cols(),
                           positions.rows(), positions.cols()));
  }
  if (!density.allFinite()) throw fail("is not finite");
  return density;
}

Eigen::MatrixXd ForceCoefficients::operator()(double time,
                                              const Eigen::Ref<const Eigen::MatrixXd>& displacement,
                                              const Eigen::Ref<const Eigen::MatrixXd>& velocity) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(displacement.rows(), displacement.cols());
  if (is_general()) {
    Eigen::MatrixXd positions = at_samples(displacement);
    if (rest_.size() > 0) positions += rest_;
    const Eigen::MatrixXd velocities = at_samples(velocity);
    Eigen::MatrixXd density = general(0, time, positions, velocities);
    for (std::size_t i = 1; i < force_.general.size(); ++i) {
      density += general(i, time, positions, velocities);
    }
    for (Eigen::Index j = 0; j < sum.cols(); ++j) {
      transform_.forward(density.col(j), sum.col(j), workspace_);
    }
  }
  if (force_.constant.size() > 0) sum += force_.constant;
  for (const HarmonicForce& harmonic : force_.harmonic) {
    const auto [sine, cosine] = sine_cosine(harmonic.omega * time);
    sum += cosine * harmonic.cosine + sine * harmonic.sine;
  }
  return sum;
}

}  // namespace wavecurve::dynamics
