#include "wavecurve/dynamics/schulz_inverse.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::dynamics {

namespace {

constexpr int most_steps = 140;
constexpr double most_products = 3e9;  // of sparse matrices: some ten seconds
constexpr double epsilon = std::numeric_limits<double>::epsilon();

using Dense = Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;

double row_sum_norm(const Dense& matrix) { return matrix.cwiseAbs().rowwise().sum().maxCoeff(); }

double row_sum_norm(const Sparse& matrix) {
  return (matrix.cwiseAbs() * Eigen::VectorXd::Ones(matrix.cols())).maxCoeff();
}

Dense identity_minus(Dense matrix) {
  matrix = -matrix;
  matrix.diagonal().array() += 1;
  return matrix;
}

Sparse identity_minus(const Sparse& matrix) {
  Sparse identity(matrix.rows(), matrix.cols());
  identity.setIdentity();
  return identity - matrix;
}

/// Drops small entries; the Frobenius norm of what was dropped.
double drop(Dense&, double) { return 0; }

double drop(Sparse& matrix, double threshold) {
  const double bound = threshold * matrix.coeffs().abs().maxCoeff();
  double square = 0;
  matrix.prune([&](Eigen::Index, Eigen::Index, double value) {
    const bool is_kept = std::abs(value) >= bound;
    if (!is_kept) square += value * value;
    return is_kept;
  });
  return std::sqrt(square);
}

/// Adds the multiplications of a product, which for sparse factors are those of an even pattern.
template <class Matrix>
void count_product(const Matrix& a, const Matrix& b, double& operations) {
  if constexpr (std::is_same_v<Matrix, Sparse>) {
    operations += static_cast<double>(a.nonZeros()) * static_cast<double>(b.nonZeros()) /
                  static_cast<double>(a.cols());
    if (operations <= most_products) return;
    throw std::domain_error(fmt::format(
        "Schulz' iteration for a matrix of {} rows takes more than {:.2g} multiplications, which "
        "is the bound: its inverse is not sparse",
        a.rows(), most_products));
  }
}

bool is_finite(const Dense& matrix) { return matrix.allFinite(); }
bool is_finite(const Sparse& matrix) { return matrix.coeffs().allFinite(); }

template <class Matrix>
void check(const Matrix& c, double tolerance, double threshold) {
  if (c.rows() != c.cols() || c.rows() == 0) {
    throw std::invalid_argument(
        fmt::format("the matrix is {} x {}, but must be square", c.rows(), c.cols()));
  }
  if (!is_finite(c)) throw std::invalid_argument("the matrix has a value that is not finite");
  check_above_zero("tolerance", tolerance);
  if (!(threshold >= 0 && threshold < 1)) {
    throw std::invalid_argument(must_be("threshold", threshold, "at least 0 and below 1"));
  }
}

template <class Matrix>
SchulzInverse<Matrix> iterate(const Matrix& c, double tolerance, double threshold) {
  check(c, tolerance, threshold);
  SchulzInverse<Matrix> result;
  const Matrix transposed = c.transpose();
  const double norm = row_sum_norm(Matrix(transposed * c));
  Matrix& x = result.inverse;
  x = norm > 0 ? Matrix(transposed / norm) : transposed;
  const double size = static_cast<double>(c.rows());
  double operations = 0;
  for (int step = 0;; ++step) {
    count_product(x, c, operations);
    const Matrix residual = identity_minus(Matrix(x * c));
    const double r = residual.norm();
    result.residuals.push_back(r);
    if (r <= tolerance) {
      result.status = SchulzStatus::converged;
      break;
    }
    // Near a half the square of the residual is clearly smaller; where it is not, rounding reigns.
    const double last = step > 0 ? result.residuals[result.residuals.size() - 2] : r;
    if (last < 0.5 && r > last / 2) break;
    // Towards the pseudo-inverse the residual stays; while it still falls by a tenth, the product
    // is not worth its time: c singular is found a step later at most.
    if (r >= 0.5 && r > 0.9 * last &&
        Matrix(c * residual).norm() <= 4 * size * epsilon * c.norm()) {
      result.status = SchulzStatus::singular;
      break;
    }
    if (step == most_steps || !std::isfinite(r)) break;
    count_product(residual, x, operations);
    x = Matrix(x + residual * x);  // 2 X - X C X
    const double dropped = drop(x, threshold);
    if (threshold > 0) result.dropped.push_back(dropped);
  }
  const double r = result.residuals.back();
  result.error_bound = r < 1 ? r / (1 - r) * x.norm() : std::numeric_limits<double>::infinity();
  return result;
}

}  // namespace

SchulzInverse<Dense> schulz_inverse(const Eigen::Ref<const Dense>& c, double tolerance) {
  return iterate<Dense>(c, tolerance, 0);
}

SchulzInverse<Sparse> schulz_inverse(const Sparse& c, double tolerance, double threshold) {
  Sparse compressed = c;
  compressed.makeCompressed();
  return iterate<Sparse>(compressed, tolerance, threshold);
}

}  // namespace wavecurve::dynamics
