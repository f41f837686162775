#include "circulant_stiffness.hpp"

#include <stdexcept>
#include <string>

#include "wavecurve/operators/connection_coefficients.hpp"

namespace wavecurve::verification {

Eigen::MatrixXd circulant_stiffness(const FilterBank<double>& bank, int samples) {
  if (samples < 1) {
    throw std::invalid_argument("a stiffness matrix of " + std::to_string(samples) +
                                " samples; at least 1 is needed");
  }
  const Filter<double> mu = connection_coefficients(bank).mu;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(samples, samples);
  for (int j = 0; j < samples; ++j) {
    for (int l = mu.first_index; l <= mu.last_index(); ++l) {
      // Wrapped as often as the support demands where it exceeds the period.
      const int i = ((j + l) % samples + samples) % samples;
      stiffness(i, j) += samples * static_cast<double>(samples) * mu[l];
    }
  }
  return stiffness;
}

}  // namespace wavecurve::verification
