#include "benchmarks/kernels/test_problem.hpp"

#include <cmath>
#include <numbers>

#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve::tracking {

dynamics::InitialValueProblem ellipse(Eigen::Index samples, Eigen::Index frames,
                                      dynamics::Material material) {
  const int levels = all_levels(samples);
  const dynamics::LagrangeSystem system(find_filter_bank<double>("db4"), samples, levels, material);
  const PeriodicTransform<double> transform(system.bank(), samples, levels);
  Eigen::VectorXd workspace(transform.workspace_size(2));
  Eigen::MatrixXd fine(samples, 2), displacement(samples, 2);
  for (Eigen::Index i = 0; i < samples; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(samples);
    fine.row(i) << 0.4 * std::cos(t), -0.4 * std::sin(t);
  }
  transform.forward(fine, displacement, workspace);
  Eigen::VectorXd times = Eigen::VectorXd::Constant(1, 1);
  if (frames > 1) times.setLinSpaced(frames, 0, 1);
  return {.system = system,
          .initial_displacement = displacement,
          .times = times,
          .with_velocities = false};
}

}  // namespace wavecurve::tracking
