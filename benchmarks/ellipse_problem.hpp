#pragma once

#include <cmath>

#include "wavecurve/dynamics/initial_value_problem.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve {

/// An ellipse released towards the unit circle, D8, all levels, t from 0 to 1.
inline dynamics::InitialValueProblem ellipse(Eigen::Index samples, Eigen::Index frames,
                                             dynamics::Material material = {}) {
  const dynamics::LagrangeSystem system(find_filter_bank<double>("db4"), samples,
                                        all_levels(samples), material);
  const PeriodicTransform<double> transform(system.bank(), samples, system.levels());
  Eigen::VectorXd workspace(transform.workspace_size());
  Eigen::MatrixXd fine(samples, 2), displacement(samples, 2);
  for (Eigen::Index i = 0; i < samples; ++i) {
    const double x = 2 * M_PI * static_cast<double>(i) / static_cast<double>(samples);
    fine.row(i) << 0.4 * std::cos(x), -0.4 * std::sin(x);
  }
  for (int j = 0; j < 2; ++j) transform.forward(fine.col(j), displacement.col(j), workspace);
  Eigen::VectorXd times = Eigen::VectorXd::Constant(1, 1);
  if (frames > 1) times.setLinSpaced(frames, 0, 1);
  return {.system = system,
          .initial_displacement = displacement,
          .times = times,
          .with_velocities = false};
}

}  // namespace wavecurve
