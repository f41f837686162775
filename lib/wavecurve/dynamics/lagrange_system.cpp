#include "wavecurve/dynamics/lagrange_system.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "wavecurve/operators/circulant.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/transform/bands.hpp"

namespace wavecurve {

namespace {

void check(const char* name, double value) {
  if (value >= 0 && std::isfinite(value)) return;
  throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
                              ", but must be finite and at least 0");
}

Eigen::VectorXd symbol(const FilterBank<double>& bank, Eigen::Index samples, int order) {
  return circulant_eigenvalues(connection_coefficients(bank, order, order).mu, samples, 2 * order)
      .head(samples / 2 + 1);
}

}  // namespace

LagrangeSystem::LagrangeSystem(FilterBank<double> bank, Eigen::Index samples, int levels,
                               const Material& material)
    : bank_(std::move(bank)), samples_(samples), levels_(levels), material_(material) {
  check("density", material.density);
  check("stiffness", material.stiffness);
  check("bending", material.bending);
  check("mass damping", material.mass_damping);
  check("stiffness damping", material.stiffness_damping);
  check("damping density", material.damping_density);
  checked_log2(samples);
  multiscale_bands(samples, levels);
  symbols();
}

Symbols LagrangeSystem::symbols() const {
  Symbols result;
  result.gram = symbol(bank_, samples_, 0);
  result.mass = material_.density * result.gram;
  result.stiffness = material_.stiffness * symbol(bank_, samples_, 1);
  if (material_.bending > 0) result.stiffness += material_.bending * symbol(bank_, samples_, 2);
  result.damping = material_.damping_density * result.gram + material_.mass_damping * result.mass +
                   material_.stiffness_damping * result.stiffness;
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

}  // namespace wavecurve
