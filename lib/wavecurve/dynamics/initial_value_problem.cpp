#include "wavecurve/dynamics/initial_value_problem.hpp"

#include <cmath>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/elementary/root.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::dynamics {

namespace {

void check_state(const char* name, const Eigen::MatrixXd& state, const InitialValueProblem& p) {
  if (state.rows() != p.system.samples() || state.cols() != p.initial_displacement.cols()) {
    throw std::invalid_argument(fmt::format("{} is {} x {}, but must be {} x {}", name,
                                            state.rows(), state.cols(), p.system.samples(),
                                            p.initial_displacement.cols()));
  }
  if (!state.allFinite()) {
    throw std::invalid_argument(std::string(name) + " has a value that is not finite");
  }
}

void check_times(const Eigen::VectorXd& times) {
  double last = 0;
  for (Eigen::Index i = 0; i < times.size(); ++i) {
    check_at_least("time " + std::to_string(i), times[i], last);
    last = times[i];
  }
}

}  // namespace

void check(const InitialValueProblem& problem) {
  check_state("the displacement", problem.initial_displacement, problem);
  if (problem.initial_velocity.size() > 0)
    check_state("the velocity", problem.initial_velocity, problem);
  if (problem.rest.size() > 0) check_state("the rest shape", problem.rest, problem);
  const Force& force = problem.force;
  if (force.constant.size() > 0) check_state("the constant force", force.constant, problem);
  for (const HarmonicForce& harmonic : force.harmonic) {
    check_state("the cosine of a harmonic force", harmonic.cosine, problem);
    check_state("the sine of a harmonic force", harmonic.sine, problem);
    if (!std::isfinite(harmonic.omega)) {
      throw std::invalid_argument("omega of a harmonic force is not finite");
    }
  }
  check_times(problem.times);
}

void keep_what_is_reached(Trajectory& trajectory, const std::function<void()>& steps) {
  try {
    steps();
  } catch (const std::bad_alloc&) {  // what the machine lacks says nothing about the solution
    throw;
  } catch (const std::exception& failure) {
    throw SolutionStopped(failure.what(), std::move(trajectory));
  }
}

Eigen::MatrixXd uniform_density(const LagrangeSystem& system,
                                const Eigen::Ref<const Eigen::RowVectorXd>& density) {
  // A constant has no wavelet coefficients, and each level of (2.8) multiplies it by sqrt 2.
  Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(system.samples(), density.cols());
  coefficients.topRows(system.samples() >> system.levels()).rowwise() =
      power_of_root_two(system.levels()) * density;
  return coefficients;
}

ForceDensity attraction(const Eigen::Ref<const Eigen::RowVectorXd>& point, double strength,
                        double softening) {
  check_above_zero("softening", softening);
  return [point = Eigen::RowVectorXd(point), strength, softening](
             double, const Eigen::Ref<const Eigen::MatrixXd>& positions,
             const Eigen::Ref<const Eigen::MatrixXd>&) {
    const Eigen::MatrixXd distance = (-positions).rowwise() + point;
    const Eigen::ArrayXd square = distance.rowwise().squaredNorm().array() + softening * softening;
    return Eigen::MatrixXd(distance.array().colwise() * (strength / (square * square.sqrt())));
  };
}

}  // namespace wavecurve::dynamics
