#include "wavecurve/curves/coefficients.hpp"

#include <cmath>

#include "wavecurve/curves/interpolation.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve {

double centre_of_phi(const FilterBank<double>& bank) {
  const Filter<double>& low = bank.synthesis_low;
  double sum = 0;
  for (int n = low.first_index; n <= low.last_index(); ++n) sum += n * low[n];
  return sum / std::sqrt(2.0);
}

Contour to_coefficients(const FilterBank<double>& bank, const Contour& samples, int levels,
                        SampleMode mode) {
  const PeriodicTransform<double> transform(bank, samples.rows(), levels);
  Eigen::VectorXd workspace(transform.workspace_size());
  const Contour finest = mode == SampleMode::interpolate ? interpolate(bank, samples) : samples;
  Contour coefficients(samples.rows(), 2);
  for (int column : {0, 1}) {
    transform.forward(finest.col(column), coefficients.col(column), workspace);
  }
  return coefficients;
}

Contour to_samples(const FilterBank<double>& bank, const Contour& coefficients, int levels,
                   SampleMode mode) {
  const PeriodicTransform<double> transform(bank, coefficients.rows(), levels);
  Eigen::VectorXd workspace(transform.workspace_size());
  Contour finest(coefficients.rows(), 2);
  for (int column : {0, 1}) {
    transform.inverse(coefficients.col(column), finest.col(column), workspace);
  }
  return mode == SampleMode::interpolate ? values_at_integers(bank, finest) : finest;
}

Contour approximation(const Contour& coefficients, Eigen::Index scale) {
  check_between("scale", scale, 1, coefficients.rows());
  Contour result = coefficients;
  result.bottomRows(result.rows() - scale).setZero();
  return result;
}

}  // namespace wavecurve
