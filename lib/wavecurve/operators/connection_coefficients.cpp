#include "wavecurve/operators/connection_coefficients.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/autocorrelation.hpp"
#include "wavecurve/filters/connection_coefficients.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

namespace {

constexpr int highest_derivative = 8;

void require_valid(const FilterBank<double>& bank, int p, int q) {
  for (const int order : {p, q}) {
    check_between("derivative order", order, 0, highest_derivative);
  }
  const double needed = 0.5 * (p + q);
  if (!(bank.sobolev_exponent > needed)) {
    throw std::domain_error(
        fmt::format("filter {} is not smooth enough for derivatives {},{}: its Sobolev exponent is "
                    "{:.4g}, but it must exceed {:.1f}",
                    bank.name, p, q, bank.sobolev_exponent, needed));
  }
}

/// mu_l for every l of the support from the unknowns of the reduced system.
Filter<double> unfold(const Eigen::VectorXd& unknowns, int support, int d, double sign) {
  const int last = support - 1, first = support - static_cast<int>(unknowns.size());
  Filter<double> mu{-last, std::vector<double>(static_cast<std::size_t>(2 * last + 1), 0.0)};
  for (int l = first; l <= last; ++l) {
    const double value = sign * unknowns[l - first];
    mu.taps[static_cast<std::size_t>(last + l)] = value;
    mu.taps[static_cast<std::size_t>(last - l)] = d % 2 == 0 ? value : -value;
  }
  return mu;
}

}  // namespace

ConnectionCoefficients<double> connection_coefficients(const FilterBank<double>& bank, int p, int q,
                                                       NullVectorMethod method) {
  require_valid(bank, p, q);
  const int d = p + q;
  const Filter<double> alpha = autocorrelation(bank.synthesis_low);
  const Eigen::Map<const Eigen::VectorXd> alpha_vector(alpha.taps.data(), alpha.size());
  const Eigen::VectorXd unknowns = two_scale_null_vector(alpha_vector, d, method);
  const double sign = p % 2 == 0 ? 1.0 : -1.0;
  ConnectionCoefficients<double> result{p, q, unfold(unknowns, alpha.size() - 1, d, sign), {}};
  result.nu = wavelet_coefficients(result.mu, autocorrelation(bank.synthesis_high), d);
  return result;
}

}  // namespace wavecurve
