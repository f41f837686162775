#include "wavecurve/dynamics/lagrange_system.hpp"

#include <cmath>
#include <numeric>
#include <utility>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/operators/circulant.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/transform/bands.hpp"

namespace wavecurve::dynamics {

namespace {

/// The symbol of the circulant of the finest level, by frequency 0 .. samples / 2.
Eigen::VectorXd symbol(const FilterBank<double>& bank, Eigen::Index samples, int order) {
  if (order == 0 && bank.is_orthonormal()) return Eigen::VectorXd::Ones(samples / 2 + 1);
  return circulant_symbol(connection_coefficients(bank, order, order).mu, samples, 2 * order);
}

/// The symbols of the diagonal blocks of the bands.
std::vector<Eigen::VectorXd> band_symbols(const FilterBank<double>& bank,
                                          const std::vector<Band>& bands, int order) {
  std::vector<Eigen::VectorXd> symbols;
  if (order == 0 && bank.is_orthonormal()) {
    for (const Band& band : bands) symbols.push_back(Eigen::VectorXd::Ones(band.size / 2 + 1));
    return symbols;
  }
  const ConnectionCoefficients<double> coefficients = connection_coefficients(bank, order, order);
  const std::vector<double>& nu = coefficients.nu.taps;
  for (const Band& band : bands) {
    symbols.push_back(circulant_symbol(band.is_scaling ? coefficients.mu : coefficients.nu,
                                       band.size, 2 * order));
    if (band.is_scaling || order == 0) continue;
    // The nu of derivatives do not sum to zero, as circulant_symbol takes for granted.
    const double scale = std::ldexp(1.0, checked_log2(band.size) * 2 * order);
    symbols.back().array() += scale * std::accumulate(nu.begin(), nu.end(), 0.0);
  }
  return symbols;
}

/// The entry on the diagonal of a circulant: the mean of its eigenvalues.
double mean(const Eigen::VectorXd& half, Eigen::Index size) {
  const double twice = 2 * half.sum() - half[0] - (size > 1 ? half[size / 2] : half[0]);
  return (size > 1 ? twice : half[0]) / static_cast<double>(size);
}

}  // namespace

LagrangeSystem::LagrangeSystem(FilterBank<double> bank, Eigen::Index samples, int levels,
                               const Material& material)
    : bank_(std::move(bank)), samples_(samples), levels_(levels), material_(material) {
  check_at_least("density", material.density, 0);
  check_at_least("stiffness", material.stiffness, 0);
  check_at_least("bending", material.bending, 0);
  check_at_least("mass damping", material.mass_damping, 0);
  check_at_least("stiffness damping", material.stiffness_damping, 0);
  check_at_least("damping density", material.damping_density, 0);
  checked_log2(samples);
  multiscale_bands(samples, levels);
  eigenvalues();
}

CirculantEigenvalues LagrangeSystem::compose(const Eigen::VectorXd& gram,
                                             const Eigen::VectorXd& first,
                                             const Eigen::VectorXd& second) const {
  CirculantEigenvalues result;
  result.gram = gram;
  result.mass = material_.density * gram;
  result.stiffness = material_.stiffness * first;
  if (material_.bending > 0) result.stiffness += material_.bending * second;
  result.damping = material_.damping_density * gram + material_.mass_damping * result.mass +
                   material_.stiffness_damping * result.stiffness;
  return result;
}

CirculantEigenvalues LagrangeSystem::eigenvalues() const {
  return compose(symbol(bank_, samples_, 0), symbol(bank_, samples_, 1),
                 material_.bending > 0 ? symbol(bank_, samples_, 2) : Eigen::VectorXd());
}

std::vector<CirculantEigenvalues> LagrangeSystem::band_eigenvalues() const {
  const std::vector<Band> bands = multiscale_bands(samples_, levels_);
  const auto gram = band_symbols(bank_, bands, 0);
  const auto first = band_symbols(bank_, bands, 1);
  const auto second = material_.bending > 0 ? band_symbols(bank_, bands, 2)
                                            : std::vector<Eigen::VectorXd>(bands.size());
  std::vector<CirculantEigenvalues> result;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    result.push_back(compose(gram[i], first[i], second[i]));
  }
  return result;
}

CirculantEigenvalues LagrangeSystem::band_diagonals() const {
  const std::vector<Band> bands = multiscale_bands(samples_, levels_);
  const auto count = static_cast<Eigen::Index>(bands.size());
  CirculantEigenvalues result = {Eigen::VectorXd(count), Eigen::VectorXd(count),
                                 Eigen::VectorXd(count), Eigen::VectorXd(count)};
  const std::vector<CirculantEigenvalues> blocks = band_eigenvalues();
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const auto band = static_cast<Eigen::Index>(i);
    result.gram[band] = mean(blocks[i].gram, bands[i].size);
    result.mass[band] = mean(blocks[i].mass, bands[i].size);
    result.damping[band] = mean(blocks[i].damping, bands[i].size);
    result.stiffness[band] = mean(blocks[i].stiffness, bands[i].size);
  }
  return result;
}

Eigen::SparseMatrix<double> LagrangeSystem::combination(double gram_factor, double first,
                                                        double second) const {
  Eigen::SparseMatrix<double> sum(samples_, samples_);
  if (gram_factor > 0) sum += gram_factor * gram(bank_, samples_, levels_);
  if (first > 0) sum += first * wavecurve::stiffness(bank_, samples_, levels_);
  if (second > 0) sum += second * multiscale_matrix(bank_, samples_, levels_, 2, 2);
  return sum;
}

Eigen::SparseMatrix<double> LagrangeSystem::mass() const {
  return combination(material_.density, 0, 0);
}

Eigen::SparseMatrix<double> LagrangeSystem::damping() const {
  return combination(material_.damping_density + material_.mass_damping * material_.density,
                     material_.stiffness_damping * material_.stiffness,
                     material_.stiffness_damping * material_.bending);
}

Eigen::SparseMatrix<double> LagrangeSystem::stiffness() const {
  return combination(0, material_.stiffness, material_.bending);
}

}  // namespace wavecurve::dynamics
