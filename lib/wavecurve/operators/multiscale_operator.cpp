#include "wavecurve/operators/multiscale_operator.hpp"

#include <algorithm>
#include <cmath>

#include "wavecurve/operators/circulant.hpp"
#include "wavecurve/transform/periodic_kernels.hpp"

namespace wavecurve {

namespace {
constexpr Eigen::Index block_size = 4096;
}

MultiscaleOperator::MultiscaleOperator(const FilterBank<double>& bank, Eigen::Index samples,
                                       int levels, int p, int q)
    : MultiscaleOperator(bank, connection_coefficients(bank, p, q), samples, levels) {}

MultiscaleOperator::MultiscaleOperator(const FilterBank<double>& bank,
                                       const ConnectionCoefficients<double>& coefficients,
                                       Eigen::Index samples, int levels)
    : transform_(bank, samples, levels),
      first_offset_(-coefficients.mu.last_index()),
      samples_(samples),
      product_(samples),
      workspace_(transform_.workspace_size()) {
  const int exponent = checked_log2(samples) * (coefficients.p + coefficients.q);
  const std::vector<double>& mu = coefficients.mu.taps;
  std::transform(mu.rbegin(), mu.rend(), std::back_inserter(weights_),
                 [exponent](double x) { return std::ldexp(x, exponent); });
  if (weights_.size() % 2 != 0) weights_.push_back(0);
  window_.resize(static_cast<std::size_t>(block_size) + weights_.size());
}

void MultiscaleOperator::apply_circulant() {
  // product_i = sum_l mu_l samples_{i-l}; the two halves of the weights make the kernel's pair.
  const int half = static_cast<int>(weights_.size() / 2);
  for (Eigen::Index i = 0; i < size(); i += block_size) {
    const Eigen::Index count = std::min(block_size, size() - i);
    const double* input = periodic_window(samples_.data(), size(), i + first_offset_,
                                          count + 2 * half - 1, window_.data());
    correlate_pair(weights_.data(), weights_.data() + half, half, input, input + half, count,
                   product_.data() + i);
  }
}

void MultiscaleOperator::apply(const Eigen::Ref<const Eigen::VectorXd>& x,
                               Eigen::Ref<Eigen::VectorXd> y) {
  transform_.inverse(x, samples_, workspace_);
  apply_circulant();
  transform_.inverse_adjoint(product_, y, workspace_);
}

}  // namespace wavecurve
