#include "wavecurve/dynamics/translation.hpp"

#include <cmath>
#include <utility>

#include "wavecurve/elementary/root.hpp"

namespace wavecurve::dynamics {

namespace {

/// The prescribed motion of the mean.
struct MeanMotion {
  Eigen::RowVectorXd start;
  double end = 0;  ///< the time at which it reaches 0; 0: never

  Eigen::RowVectorXd at(double t) const { return (end > 0 ? 1 - t / end : 1) * start; }
  Eigen::RowVectorXd velocity() const { return (end > 0 ? -1 / end : 0) * start; }
};

void remove_mean(const LagrangeSystem& system, Eigen::MatrixXd& coefficients) {
  if (coefficients.size() == 0) return;
  coefficients -= uniform_density(system, mean(system, coefficients));
}

/// Forces are given and asked for at sample points.
ForceDensity without_mean(ForceDensity force, const MeanMotion& motion) {
  return [force = std::move(force), motion](double t,
                                            const Eigen::Ref<const Eigen::MatrixXd>& positions,
                                            const Eigen::Ref<const Eigen::MatrixXd>& velocities) {
    Eigen::MatrixXd density =
        force(t, positions.rowwise() + motion.at(t), velocities.rowwise() + motion.velocity());
    const Eigen::RowVectorXd average = density.colwise().mean();
    density.rowwise() -= average;
    return density;
  };
}

InitialValueProblem without_mean(InitialValueProblem problem, const MeanMotion& motion) {
  const LagrangeSystem& system = problem.system;
  remove_mean(system, problem.initial_displacement);
  remove_mean(system, problem.initial_velocity);
  remove_mean(system, problem.force.constant);
  for (HarmonicForce& harmonic : problem.force.harmonic) {
    remove_mean(system, harmonic.cosine);
    remove_mean(system, harmonic.sine);
  }
  for (ForceDensity& force : problem.force.general) force = without_mean(std::move(force), motion);
  return problem;
}

void add_mean(Trajectory& trajectory, const InitialValueProblem& problem,
              const MeanMotion& motion) {
  for (std::size_t i = 0; i < trajectory.displacement.size(); ++i) {
    const double t = problem.times[static_cast<Eigen::Index>(i)];
    trajectory.displacement[i] += uniform_density(problem.system, motion.at(t));
    if (i < trajectory.velocity.size()) {
      trajectory.velocity[i] += uniform_density(problem.system, motion.velocity());
    }
  }
}

}  // namespace

Eigen::RowVectorXd mean(const LagrangeSystem& system,
                        const Eigen::Ref<const Eigen::MatrixXd>& coefficients) {
  // Wavelets have mean zero, and each level of (2.8) multiplies the mean by sqrt 2.
  const Eigen::Index scaling = system.samples() >> system.levels();
  return coefficients.topRows(scaling).colwise().mean() / power_of_root_two(system.levels());
}

Solver with_translation(Solver solver, Translation translation) {
  if (translation == Translation::free) return solver;
  return [solver = std::move(solver), translation](const InitialValueProblem& problem) {
    check(problem);
    MeanMotion motion = {mean(problem.system, problem.initial_displacement), 0};
    if (translation == Translation::interpolated && problem.times.size() > 0) {
      motion.end = problem.times[problem.times.size() - 1];
    }
    try {
      Trajectory trajectory = solver(without_mean(problem, motion));
      add_mean(trajectory, problem, motion);
      return trajectory;
    } catch (const SolutionStopped& stopped) {
      Trajectory reached = stopped.reached();
      add_mean(reached, problem, motion);
      throw SolutionStopped(stopped.what(), std::move(reached));
    }
  };
}

}  // namespace wavecurve::dynamics
