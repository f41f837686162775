#include "wavecurve/operators/spectrum.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <Spectra/SymEigsSolver.h>
#include <fmt/format.h>

#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/operators/circulant.hpp"
#include "wavecurve/operators/connection_coefficients.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/operators/multiscale_operator.hpp"
#include "wavecurve/transform/fourier_transform.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve {

namespace {

constexpr double residual_tolerance = 1e-6;
constexpr Eigen::Index smallest_iterated = 64;

/// The interface that Spectra asks of an operator.
class Product {
 public:
  using Scalar = double;
  explicit Product(MultiscaleOperator& matrix) : matrix_(&matrix) {}
  Eigen::Index rows() const { return matrix_->size(); }
  Eigen::Index cols() const { return matrix_->size(); }
  void perform_op(const double* x, double* y) const {
    matrix_->apply(Eigen::Map<const Eigen::VectorXd>(x, rows()),
                   Eigen::Map<Eigen::VectorXd>(y, rows()));
  }

 private:
  MultiscaleOperator* matrix_;
};

/// P S^-1 T^+ S^-T P, P the orthogonal projection off the matrix's null space: the inverse of
/// S^T T S on the complement.
class InverseProduct {
 public:
  using Scalar = double;
  InverseProduct(const FilterBank<double>& bank, const ConnectionCoefficients<double>& coefficients,
                 Eigen::Index samples, int levels)
      : transform_(bank, samples, levels),
        fourier_(samples),
        workspace_(transform_.workspace_size()) {
    inverse_eigenvalues_ =
        circulant_eigenvalues(coefficients.mu, samples, 2 * coefficients.p).cwiseInverse();
    if (coefficients.p == 0) return;
    inverse_eigenvalues_[0] = 0;
    constants_ = samples >> levels;
  }
  Eigen::Index rows() const { return transform_.samples(); }
  Eigen::Index cols() const { return rows(); }

  void perform_op(const double* x, double* y) const {
    Eigen::VectorXd coefficients = Eigen::Map<const Eigen::VectorXd>(x, rows()), samples(rows());
    project(coefficients);
    transform_.forward_adjoint(coefficients, samples, workspace_);
    Eigen::VectorXcd spectrum = samples.cast<std::complex<double>>();
    fourier_.forward(spectrum);
    spectrum.array() *= inverse_eigenvalues_.array();
    fourier_.inverse(spectrum);
    samples = spectrum.real();
    transform_.forward(samples, coefficients, workspace_);
    project(coefficients);
    Eigen::Map<Eigen::VectorXd>(y, rows()) = coefficients;
  }

 private:
  /// The null vector is one for each scaling function and zero for the wavelets.
  void project(Eigen::VectorXd& x) const {
    if (constants_ > 0) x.head(constants_).array() -= x.head(constants_).mean();
  }

  PeriodicTransform<double> transform_;
  Eigen::VectorXd inverse_eigenvalues_;
  Eigen::Index constants_ = 0;
  mutable FourierTransform fourier_;
  mutable Eigen::VectorXd workspace_;
};

/// `start` may be empty: a random vector, the same in every run.
template <class Operator>
double largest_eigenvalue(Operator& product, const Eigen::VectorXd& start = {}) {
  constexpr int krylov_dimension = 60, restarts = 2000;
  Spectra::SymEigsSolver<Operator> solver(product, 1, krylov_dimension);
  if (start.size() > 0) {
    solver.init(start.data());
  } else {
    solver.init();
  }
  solver.compute(Spectra::SortRule::LargestAlge, restarts, residual_tolerance);
  if (solver.info() != Spectra::CompInfo::Successful) {
    throw std::runtime_error(fmt::format(
        "the largest of {} eigenvalues did not converge in {} restarts", product.rows(), restarts));
  }
  return solver.eigenvalues()[0];
}

/// The circulant's eigenvector of its largest eigenvalue, in the multiscale basis. The largest
/// eigenvalues of large matrices are so close together that the iteration from a random vector
/// takes minutes; for an orthonormal bank this vector is next to the answer.
Eigen::VectorXd highest_mode(const FilterBank<double>& bank,
                             const ConnectionCoefficients<double>& coefficients,
                             Eigen::Index samples, int levels) {
  Eigen::Index frequency;
  circulant_eigenvalues(coefficients.mu, samples, 2 * coefficients.p).maxCoeff(&frequency);
  Eigen::VectorXd mode(samples), result(samples);
  for (Eigen::Index n = 0; n < samples; ++n) {
    const auto phase = static_cast<double>(frequency * n % samples) / static_cast<double>(samples);
    mode[n] = cosine(2 * std::numbers::pi * phase);
  }
  mode[0] += 1;  // a trace of every other mode: from an exact eigenvector Lanczos breaks down
  const PeriodicTransform<double> transform(bank, samples, levels);
  Eigen::VectorXd workspace(transform.workspace_size());
  transform.forward(mode, result, workspace);
  return result;
}

ExtremeEigenvalues dense_extremes(const Eigen::MatrixXd& matrix, Eigen::Index null_space) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix, Eigen::EigenvaluesOnly);
  const Eigen::VectorXd& ascending = solver.eigenvalues();
  return {ascending[null_space], ascending[ascending.size() - 1]};
}

}  // namespace

ExtremeEigenvalues extreme_eigenvalues(const FilterBank<double>& bank, Eigen::Index samples,
                                       int levels, int p) {
  check_between("p", p, 0, 1);
  check_at_least("samples", samples, 2);
  if (p == 0 && bank.is_orthonormal()) {
    gram(bank, samples, levels);  // refuses what it must
    return {1, 1};
  }
  const auto coefficients = connection_coefficients(bank, p, p);
  if (samples < smallest_iterated) {
    return dense_extremes(multiscale_matrix(bank, coefficients, samples, levels), p);
  }
  MultiscaleOperator matrix(bank, coefficients, samples, levels);
  Product product(matrix);
  const Eigen::VectorXd start =
      bank.is_orthonormal() ? highest_mode(bank, coefficients, samples, levels) : Eigen::VectorXd();
  InverseProduct inverse(bank, coefficients, samples, levels);
  return {1 / largest_eigenvalue(inverse), largest_eigenvalue(product, start)};
}

Eigen::VectorXd vibration_eigenvalues(const FilterBank<double>& bank, Eigen::Index samples) {
  const Eigen::VectorXd k =
      circulant_eigenvalues(connection_coefficients(bank, 1, 1).mu, samples, 2);
  const Eigen::VectorXd m =
      circulant_eigenvalues(connection_coefficients(bank, 0, 0).mu, samples, 0);
  return k.cwiseQuotient(m);
}

}  // namespace wavecurve
