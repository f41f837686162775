#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "verification/quantities/quantity.hpp"

namespace wavecurve::verification {

/// How a program may have found the null vector of A in (3.11).
enum class NullVector {
  eigenvector,                ///< of the eigenvalue nearest zero
  singular_vector,            ///< right, of the smallest singular value
  shift_invert,               ///< the eigenvector by iteration
  constrained,                ///< the last equation replaced by the moment condition
  least_squares,              ///< all equations as well as they can be met with mu_0 = 1
  least_squares_with_moment,  ///< all equations and the moment condition, weighted alike
  without_equation,           ///< the equations but one, with mu_0 = 1 in its place
};

struct NullVectorRoute {
  std::string name;
  NullVector kind = NullVector::eigenvector;
  Eigen::Index dropped = 0;  ///< of without_equation
};

/// mu, nu (3.14), or one of them divided by its first entry, from the null vector of the alpha's A
/// scaled by sum_l l^2 mu_l = -2. Nothing where no null vector is found, or infinities.
std::optional<Eigen::VectorXd> coefficient_column(const Quantity& quantity,
                                                  const Eigen::VectorXd& alpha,
                                                  const NullVectorRoute& route);

/// Bounds of the rounding errors of coefficient_column, entry by entry, to first order in eps =
/// 2^-52. The model is that of backward stable programs: the n unknowns x satisfy the equations M
/// that the route solves up to a residual r,
///
///   |r_i| <= n eps (|M| |x|)_i     by elimination (constrained, without_equation),
///   |r|_2 <= n eps |M|_F |x|_2     by orthogonal transformations and iterations (all others),
///
/// and an alpha known up to delta adds A(delta) |x|. The inverse of M (for least squares the
/// pseudoinverse, for an eigenvector or singular vector the inverse of the system bordered by its
/// scale) carries r to x. Scaling, (3.14) and the quotient follow, and n eps of each value for
/// their own rounding.
Eigen::VectorXd coefficient_errors(const Quantity& quantity, const Eigen::VectorXd& alpha,
                                   const Eigen::VectorXd& alpha_errors,
                                   const NullVectorRoute& route);

}  // namespace wavecurve::verification
