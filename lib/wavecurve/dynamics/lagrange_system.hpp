#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve::dynamics {

/// The constants of M q'' + C q' + K q = Q with G, D_1, D_2 the integrals of products of the basis
/// functions, of their first and of their second derivatives (operators/multiscale_matrix.hpp):
///   M = density G,   K = stiffness D_1 + bending D_2,
///   C = damping_density G + mass_damping M + stiffness_damping K.
/// The publication's rho, e_0, s_1, s_2, (3.3)-(3.5), and two more: bending, and the damping
/// density, without which C would be singular at density 0.
///
/// The parameter of the curve runs over the unit interval, whatever its length in the drawing, and
/// density and stiffness are per unit of it: the n-th mode of an undamped free curve has the
/// angular frequency 2 pi n sqrt(stiffness / density) per unit of time.
struct Material {
  double density = 1, stiffness = 1, bending = 0;
  double mass_damping = 0, stiffness_damping = 0, damping_density = 0;
};

/// The eigenvalues of the mass, damping and stiffness matrices on the finest level, where they are
/// circulants, by frequency n = 0 .. samples / 2 (those of samples - n are the same). Frequency 0
/// is the translation, of which only mass and damping act.
struct CirculantEigenvalues {
  Eigen::VectorXd gram, mass, damping, stiffness;
};

/// The system (3.3) on the periodized multiscale basis of a bank, coefficients in global-to-local
/// order. Holds for every bank: the mass matrix is the Gram matrix, diagonal only if orthonormal.
class LagrangeSystem {
 public:
  /// Throws std::invalid_argument naming a constant that is negative or not finite, and as
  /// multiscale_matrix does; std::domain_error if the bank is not smooth enough for the stiffness,
  /// or for the bending if there is any.
  LagrangeSystem(FilterBank<double> bank, Eigen::Index samples, int levels,
                 const Material& material);

  const FilterBank<double>& bank() const { return bank_; }
  Eigen::Index samples() const { return samples_; }
  int levels() const { return levels_; }
  const Material& material() const { return material_; }

  CirculantEigenvalues eigenvalues() const;
  /// The same of the diagonal block of each band, circulants too, by frequency 0 .. size / 2.
  std::vector<CirculantEigenvalues> band_eigenvalues() const;
  /// The entries on the diagonals, by band: within a band they are all the same.
  CirculantEigenvalues band_diagonals() const;
  Eigen::SparseMatrix<double> mass() const, damping() const, stiffness() const;

 private:
  /// With K and C composed of the three.
  CirculantEigenvalues compose(const Eigen::VectorXd& gram, const Eigen::VectorXd& first,
                               const Eigen::VectorXd& second) const;
  /// gram G + first D_1 + second D_2.
  Eigen::SparseMatrix<double> combination(double gram, double first, double second) const;

  FilterBank<double> bank_;
  Eigen::Index samples_;
  int levels_;
  Material material_;
};

}  // namespace wavecurve::dynamics
