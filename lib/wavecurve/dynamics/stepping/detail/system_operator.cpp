#include "wavecurve/dynamics/stepping/detail/system_operator.hpp"

#include <cmath>

#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/operators/circulant.hpp"
#include "wavecurve/transform/bands.hpp"

namespace wavecurve::dynamics {

namespace {

void add(Filter<double>& sum, double factor, const Filter<double>& mu) {
  if (factor == 0) return;
  Filter<double> result{std::min(sum.first_index, mu.first_index), {}};
  const int last = std::max(sum.last_index(), mu.last_index());
  for (int l = result.first_index; l <= last; ++l) result.taps.push_back(sum[l] + factor * mu[l]);
  sum = result;
}

/// As coefficients of order (0, 0), which have no scale of their own: the powers of two of the
/// derivatives are in the factors.
ConnectionCoefficients<double> combined(const LagrangeSystem& system, double gram,
                                        double stiffness) {
  const Material& material = system.material();
  const int level = checked_log2(system.samples());
  ConnectionCoefficients<double> sum = {0, 0, {0, {0.0}}, {}};
  if (system.bank().is_orthonormal()) {
    add(sum.mu, gram, {0, {1.0}});
  } else {
    add(sum.mu, gram, connection_coefficients(system.bank(), 0, 0).mu);
  }
  add(sum.mu, std::ldexp(stiffness * material.stiffness, 2 * level),
      connection_coefficients(system.bank(), 1, 1).mu);
  if (material.bending == 0) return sum;
  add(sum.mu, std::ldexp(stiffness * material.bending, 4 * level),
      connection_coefficients(system.bank(), 2, 2).mu);
  return sum;
}

}  // namespace

SystemOperator::SystemOperator(const LagrangeSystem& system, double gram, double stiffness)
    : operator_(system.bank(), combined(system, gram, stiffness), system.samples(),
                system.levels()),
      diagonal_(system.samples()) {
  const CirculantEigenvalues diagonals = system.band_diagonals();
  Eigen::Index i = 0;
  for (const Band& band : multiscale_bands(system.samples(), system.levels())) {
    diagonal_.segment(band.offset, band.size)
        .setConstant(gram * diagonals.gram[i] + stiffness * diagonals.stiffness[i]);
    ++i;
  }
  const auto n = static_cast<long long>(system.samples());
  const long long taps = system.bank().synthesis_low.size() + system.bank().synthesis_high.size();
  const long long width = combined(system, gram, stiffness).mu.size();
  // Each sample of each level takes half of the taps of both filters, twice.
  operations_ = 4 * taps * (n - (n >> system.levels())) + 2 * width * n;
}

void SystemOperator::apply(const Eigen::Ref<const Eigen::MatrixXd>& x,
                           Eigen::Ref<Eigen::MatrixXd> y) {
  for (Eigen::Index j = 0; j < x.cols(); ++j) operator_.apply(x.col(j), y.col(j));
}

ReducedStiffness::ReducedStiffness(const LagrangeSystem& system) {
  if (system.bank().is_orthonormal()) {
    stiffness_ = std::make_unique<SystemOperator>(system, 0, 1);
  } else {
    fourier_ = fourier_basis(system);
  }
}

void ReducedStiffness::apply(const Eigen::Ref<const Eigen::MatrixXd>& x,
                             Eigen::Ref<Eigen::MatrixXd> y) {
  if (stiffness_) return stiffness_->apply(x, y);
  ModalCoefficients spectrum = fourier_->forward(x);
  const CirculantEigenvalues& modes = fourier_->modes();
  for (Eigen::Index k = 0; k < spectrum.rows(); ++k) {
    const Eigen::Index n = fourier_->mode(k);
    spectrum.row(k) *= modes.stiffness[n] / modes.gram[n];
  }
  y = fourier_->backward(std::move(spectrum), x.cols());
}

long long ReducedStiffness::operations() const {
  // A change of basis has two coordinates, and there are two changes.
  return stiffness_ ? stiffness_->operations() : fourier_->operations() + 2 * fourier_->rows();
}

}  // namespace wavecurve::dynamics
