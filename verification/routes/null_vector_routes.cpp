#include "verification/routes/null_vector_routes.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/LU>
#include <Eigen/QR>

#include "wavecurve/operators/two_scale_system.hpp"

namespace wavecurve::verification {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// l^2, counted for l and -l.
VectorXd moment_weights(Index unknowns) {
  VectorXd weights(unknowns);
  for (Index l = 0; l < unknowns; ++l) weights[l] = 2.0 * static_cast<double>(l * l);
  return weights;
}

MatrixXd replaced_row(MatrixXd a, Index row, const VectorXd& by) {
  a.row(row) = by.transpose();
  return a;
}

MatrixXd with_row(const MatrixXd& a, const VectorXd& row) {
  MatrixXd extended(a.rows() + 1, a.cols());
  extended << a, row.transpose();
  return extended;
}

/// A vector of any scale. Throws std::domain_error where the route finds none.
VectorXd null_vector(const VectorXd& alpha, const NullVectorRoute& route) {
  const MatrixXd a = two_scale_matrix(alpha);
  const Index n = a.cols();
  switch (route.kind) {
    case NullVector::eigenvector:
      return two_scale_null_vector(alpha, 2, NullVectorMethod::eigenvector);
    case NullVector::singular_vector:
      return two_scale_null_vector(alpha, 2, NullVectorMethod::singular_vector);
    case NullVector::shift_invert:
      return two_scale_null_vector(alpha, 2, NullVectorMethod::shift_invert);
    case NullVector::constrained:
      return two_scale_null_vector(alpha, 2, NullVectorMethod::constrained);
    case NullVector::least_squares: {
      VectorXd mu(n);
      mu << 1, a.rightCols(n - 1).colPivHouseholderQr().solve(-a.col(0));
      return mu;
    }
    case NullVector::least_squares_with_moment:
      return with_row(a, moment_weights(n))
          .colPivHouseholderQr()
          .solve(-2 * VectorXd::Unit(n + 1, n));
    case NullVector::without_equation:
      return replaced_row(a, route.dropped, VectorXd::Unit(n, 0))
          .partialPivLu()
          .solve(VectorXd::Unit(n, route.dropped));
  }
  throw std::invalid_argument("unknown way to a null vector");
}

/// A column as a linear map of a null vector, divided by a linear form and times a constant.
struct ColumnMap {
  MatrixXd map;
  VectorXd scale;  ///< the form
  double constant = 1;
};

ColumnMap column_map(const Quantity& quantity, Index n) {
  ColumnMap result{MatrixXd::Identity(n, n), moment_weights(n), -2};
  if (quantity == Quantity::nu || quantity == Quantity::nu_normalized) {  // (3.14); mu ends at n
    result.map = -result.map;
    for (Index l = 0; 2 * l < n; ++l) result.map(l, 2 * l) += 8;
  }
  if (quantity == Quantity::mu_normalized || quantity == Quantity::nu_normalized) {
    result.scale = result.map.row(0);
    result.constant = 1;
  }
  return result;
}

/// The equations that a route solves, and the matrix that turns their residual into the error.
struct Amplification {
  MatrixXd equations, inverse;
};

bool is_by_elimination(NullVector kind) {
  return kind == NullVector::constrained || kind == NullVector::without_equation;
}

/// The inverse of (m - lambda) y = r with the scale of y kept, x being the vector for lambda.
MatrixXd bordered_inverse(const MatrixXd& m, const VectorXd& x) {
  const Index n = m.rows();
  const double lambda = x.dot(m * x) / x.squaredNorm();
  MatrixXd bordered(n + 1, n + 1);
  bordered << m - lambda * MatrixXd::Identity(n, n), x, VectorXd::Unit(n, 0).transpose(), 0.0;
  return MatrixXd(bordered.partialPivLu().inverse()).topLeftCorner(n, n);
}

MatrixXd pseudoinverse(const MatrixXd& m) {
  return m.completeOrthogonalDecomposition().pseudoInverse();
}

Amplification amplification(const MatrixXd& a, const VectorXd& x, const NullVectorRoute& route) {
  const Index n = a.cols();
  const auto of_square = [](const MatrixXd& m) {
    return Amplification{m, m.partialPivLu().inverse()};
  };
  switch (route.kind) {
    case NullVector::eigenvector:
    case NullVector::shift_invert:
      return {a, bordered_inverse(a, x)};
    case NullVector::singular_vector:
      return {a, bordered_inverse(a.transpose() * a, x) * a.transpose()};
    case NullVector::constrained:
      return of_square(replaced_row(a, n - 1, moment_weights(n)));
    case NullVector::without_equation:
      return of_square(replaced_row(a, route.dropped, VectorXd::Unit(n, 0)));
    case NullVector::least_squares: {
      MatrixXd inverse = MatrixXd::Zero(n, n);
      inverse.bottomRows(n - 1) = pseudoinverse(a.rightCols(n - 1));
      return {a, inverse};
    }
    case NullVector::least_squares_with_moment: {
      const MatrixXd equations = with_row(a, moment_weights(n));
      return {equations, pseudoinverse(equations)};
    }
  }
  throw std::invalid_argument("unknown way to a null vector");
}

}  // namespace

std::optional<VectorXd> coefficient_column(const Quantity& quantity, const VectorXd& alpha,
                                           const NullVectorRoute& route) {
  try {
    const VectorXd x = null_vector(alpha, route);
    const ColumnMap column = column_map(quantity, x.size());
    const VectorXd values = column.map * x * (column.constant / column.scale.dot(x));
    if (values.allFinite()) return values;
  } catch (const std::domain_error&) {  // an iteration that did not converge is no route
  }
  return std::nullopt;
}

VectorXd coefficient_errors(const Quantity& quantity, const VectorXd& alpha,
                            const VectorXd& alpha_errors, const NullVectorRoute& route) {
  const MatrixXd a = two_scale_matrix(alpha);
  const VectorXd x = null_vector(alpha, route), magnitudes = x.cwiseAbs();
  const auto [equations, inverse] = amplification(a, x, route);
  const double n_eps = static_cast<double>(x.size()) * std::numeric_limits<double>::epsilon();
  // A is alpha's entries and constants.
  const MatrixXd uncertain =
      two_scale_matrix(alpha_errors) - two_scale_matrix(VectorXd::Zero(alpha.size()));
  VectorXd residual = VectorXd::Zero(equations.rows());
  residual.head(x.size()) = uncertain.cwiseAbs() * magnitudes;
  VectorXd errors = VectorXd::Zero(x.size());
  if (is_by_elimination(route.kind)) {
    residual += n_eps * (equations.cwiseAbs() * magnitudes);
  } else {
    errors = inverse.rowwise().norm() * (n_eps * equations.norm() * x.norm());
  }
  errors += inverse.cwiseAbs() * residual;

  const ColumnMap column = column_map(quantity, x.size());
  const double scale = column.scale.dot(x);
  const double scale_error = column.scale.cwiseAbs().dot(errors);
  const VectorXd mapped = (column.map * x).cwiseAbs();
  return std::abs(column.constant / scale) *
         (column.map.cwiseAbs() * errors + mapped * (scale_error / std::abs(scale) + n_eps));
}

}  // namespace wavecurve::verification
