#include "wavecurve/operators/multiscale_operator.hpp"

#include <algorithm>
#include <cmath>

#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/operators/circulant.hpp"
#include "wavecurve/operators/detail/circulant_product.hpp"
#include "wavecurve/transform/detail/periodic_kernels.hpp"

namespace wavecurve {

namespace {
constexpr Eigen::Index block_size = 256;  // only blocks that wrap around are copied
}

MultiscaleOperator::MultiscaleOperator(const FilterBank<double>& bank, Eigen::Index samples,
                                       int levels, int p, int q)
    : MultiscaleOperator(bank, connection_coefficients(bank, p, q), samples, levels) {}

MultiscaleOperator::MultiscaleOperator(const FilterBank<double>& bank,
                                       const ConnectionCoefficients<double>& coefficients,
                                       Eigen::Index samples, int levels)
    : transform_(bank, samples, levels),
      sign_((coefficients.p + coefficients.q) % 2 == 0 ? 1 : -1),
      samples_(samples),
      product_(samples),
      workspace_(transform_.workspace_size()) {
  const int exponent = checked_log2(samples) * (coefficients.p + coefficients.q);
  for (int l = 0; l <= coefficients.mu.last_index(); ++l) {
    weights_.push_back(std::ldexp(coefficients.mu[l], exponent));
  }
  window_.resize(static_cast<std::size_t>(block_size) + 2 * weights_.size());
}

void MultiscaleOperator::apply_circulant() {
  const auto reach = static_cast<Eigen::Index>(weights_.size()) - 1;
  for (Eigen::Index i = 0; i < size(); i += block_size) {
    const Eigen::Index count = std::min(block_size, size() - i);
    const double* input =
        periodic_window(samples_.data(), size(), i - reach, count + 2 * reach, window_.data());
    circulant_product(weights_, sign_, input + reach, count, product_.data() + i);
  }
}

void MultiscaleOperator::apply(const Eigen::Ref<const Eigen::VectorXd>& x,
                               Eigen::Ref<Eigen::VectorXd> y) {
  transform_.inverse(x, samples_, workspace_);
  apply_circulant();
  transform_.inverse_adjoint(product_, y, workspace_);
}

}  // namespace wavecurve
