#pragma once

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// The ends of the spectrum of a positive semi-definite matrix, its null space left out.
struct ExtremeEigenvalues {
  double smallest = 0, largest = 0;
  double condition_number() const { return largest / smallest; }
};

/// Extreme eigenvalues of the multiscale matrix of orders (p, p), p = 0 (the Gram matrix) or 1 (stiffness, on the
/// complement of the constants), by Spectra's Lanczos iteration without assembling anything: the
/// largest from products with the matrix, the smallest as the inverse of the largest eigenvalue of
/// the inverse, S^-1 T^+ S^-T on that complement, T the circulant of the finest level, which the
/// Fourier transform inverts. The relative residual r is at most 1e-6, which bounds the relative
/// error of the eigenvalue; it is of the order r^2 / (relative distance to the next one), mostly
/// below 1e-10. Below 64 samples: from all eigenvalues of the dense matrix. Throws
/// std::invalid_argument for p outside 0 .. 1, for samples below 2, as multiscale_matrix does;
/// std::runtime_error if the iteration does not converge.
ExtremeEigenvalues extreme_eigenvalues(const FilterBank<double>& bank, Eigen::Index samples,
                                       int levels, int p);

/// The eigenvalues of the pencil (K, M), K x = lambda M x, which do not depend on the basis: those
/// of the finest level's circulants, by frequency. That of k tends to (2 pi k)^2 for every family.
Eigen::VectorXd vibration_eigenvalues(const FilterBank<double>& bank, Eigen::Index samples);

}  // namespace wavecurve
