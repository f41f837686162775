#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "wavecurve/dynamics/initial_value_problem.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/bands.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve::dynamics {

/// Coefficients of the curve whose samples are given.
inline Eigen::MatrixXd coefficients_of(const LagrangeSystem& system,
                                       const Eigen::MatrixXd& samples) {
  const PeriodicTransform<double> transform(system.bank(), system.samples(), system.levels());
  Eigen::VectorXd workspace(transform.workspace_size());
  Eigen::MatrixXd coefficients(samples.rows(), samples.cols());
  for (Eigen::Index j = 0; j < samples.cols(); ++j) {
    transform.forward(samples.col(j), coefficients.col(j), workspace);
  }
  return coefficients;
}

/// One period of a curve with a few smooth modes; shift moves the start point by so many samples.
inline Eigen::MatrixXd smooth_samples(Eigen::Index count, Eigen::Index shift = 0) {
  Eigen::MatrixXd samples(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double x = 2 * M_PI * static_cast<double>(i + shift) / static_cast<double>(count);
    samples.row(i) << 0.4 * std::cos(x) + 0.1 * std::sin(2 * x), -0.3 * std::sin(x);
  }
  return samples;
}

/// Released at rest from smooth_samples, all levels.
inline InitialValueProblem smooth_problem(const std::string& filter, Eigen::Index samples,
                                          const Material& material) {
  const int levels = all_levels(samples);
  const LagrangeSystem system(find_filter_bank<double>(filter), samples, levels, material);
  return {.system = system,
          .initial_displacement = coefficients_of(system, smooth_samples(samples)),
          .times = Eigen::VectorXd::LinSpaced(5, 0, 1)};
}

/// The coefficients of the curve whose start point is moved by so many samples, a multiple of the
/// coarsest spacing.
inline Eigen::MatrixXd shifted(const LagrangeSystem& system, const Eigen::MatrixXd& coefficients,
                               Eigen::Index shift) {
  Eigen::MatrixXd result = coefficients;
  for (const Band& band : multiscale_bands(system.samples(), system.levels())) {
    const Eigen::Index by = shift * band.size / system.samples();
    for (Eigen::Index n = 0; n < band.size; ++n) {
      result.row(band.offset + n) = coefficients.row(band.offset + (n + by) % band.size);
    }
  }
  return result;
}

inline double largest_difference(const std::vector<Eigen::MatrixXd>& a,
                                 const std::vector<Eigen::MatrixXd>& b) {
  double value = a.size() == b.size() ? 0 : INFINITY;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    value = std::max(value, (a[i] - b[i]).norm());
  }
  return value;
}

}  // namespace wavecurve::dynamics
