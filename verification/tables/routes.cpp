#include "verification/tables/routes.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include "wavecurve/operators/two_scale_system.hpp"

namespace wavecurve::verification {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd round_to_decimals(const VectorXd& values, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return values.unaryExpr([scale](double x) { return std::nearbyint(x * scale) / scale; });
}

std::string decimals_text(int n) { return " rounded to " + std::to_string(n) + " decimals"; }

/// The column's own number of decimals first, then what tables usually have.
std::vector<int> roundings(int column_decimals) {
  constexpr int fewest = 6, most = 15;  // a double holds no more
  std::vector<int> result;
  if (column_decimals >= 1 && column_decimals <= most) result.push_back(column_decimals);
  for (int n = most; n >= fewest; --n) {
    if (n != column_decimals) result.push_back(n);
  }
  return result;
}

double tap_factor(const Quantity& quantity) {
  if (quantity == Quantity::taps_sum_2) return std::numbers::sqrt2;
  if (quantity == Quantity::taps_sum_1) return 1 / std::numbers::sqrt2;
  return 1;
}

// --- list 1: where the taps come from ---

std::vector<RouteValues> tap_sources(const RouteInput& input) {
  std::vector<RouteValues> sources{{"the true taps", input.taps}};
  if (input.published_taps.size() > 0) {
    sources.push_back({"the taps of " + input.published_taps_name, input.published_taps});
  }
  sources.push_back({"taps in single precision", input.taps.cast<float>().cast<double>()});
  for (const int n : roundings(input.decimals)) {
    for (const Quantity& normalization :
         {Quantity::taps, Quantity::taps_sum_1, Quantity::taps_sum_2}) {
      const double factor = tap_factor(normalization);
      sources.push_back({to_string(normalization) + decimals_text(n),
                         round_to_decimals(input.taps * factor, n) / factor});
    }
  }
  return sources;
}

// --- list 2: where alpha comes from ---

VectorXd autocorrelation_of(const VectorXd& taps, bool orthonormal) {
  VectorXd alpha(taps.size());
  for (Index n = 0; n < taps.size(); ++n) {
    alpha[n] = 2 * taps.head(taps.size() - n).dot(taps.tail(taps.size() - n));
    if (orthonormal && n % 2 == 0) alpha[n] = n == 0 ? 2 : 0;
  }
  return alpha;
}

std::vector<RouteValues> alpha_sources(const RouteInput& input) {
  std::vector<RouteValues> sources;
  if (input.printed_alpha.size() > 0) sources.push_back({"alpha as printed", input.printed_alpha});
  for (const auto& [name, taps] : tap_sources(input)) {
    const VectorXd alpha = autocorrelation_of(taps, input.orthonormal);
    sources.push_back({"alpha from " + name, alpha});
    sources.push_back({"alpha from " + name + ", alpha" + decimals_text(input.decimals),
                       round_to_decimals(alpha, input.decimals)});
  }
  return sources;
}

// --- list 3: how the null vector is found ---

using Solver = std::function<VectorXd(const VectorXd& alpha)>;

struct NamedSolver {
  std::string name;
  Solver solve;  ///< a vector of any scale; throws std::domain_error where it finds none
};

/// The equations but one, with mu_0 = 1 in its place.
VectorXd without_equation(const VectorXd& alpha, Index dropped) {
  MatrixXd a = two_scale_matrix(alpha);
  a.row(dropped).setZero();
  a(dropped, 0) = 1;
  return a.partialPivLu().solve(VectorXd::Unit(a.rows(), dropped));
}

/// All equations as well as they can be met with mu_0 = 1.
VectorXd least_squares(const VectorXd& alpha) {
  const MatrixXd a = two_scale_matrix(alpha);
  VectorXd mu(a.cols());
  mu[0] = 1;
  mu.tail(a.cols() - 1) = a.rightCols(a.cols() - 1).colPivHouseholderQr().solve(-a.col(0));
  return mu;
}

/// All equations and the moment condition, weighted alike.
VectorXd least_squares_with_moment(const VectorXd& alpha) {
  const MatrixXd a = two_scale_matrix(alpha);
  MatrixXd extended(a.rows() + 1, a.cols());
  extended.topRows(a.rows()) = a;
  for (Index l = 0; l < a.cols(); ++l) extended(a.rows(), l) = 2.0 * static_cast<double>(l * l);
  return extended.colPivHouseholderQr().solve(-2 * VectorXd::Unit(a.rows() + 1, a.rows()));
}

Solver library_solver(NullVectorMethod method) {
  return [method](const VectorXd& alpha) { return two_scale_null_vector(alpha, 2, method); };
}

std::vector<NamedSolver> null_vector_solvers(Index unknowns) {
  std::vector<NamedSolver> solvers{
      {"mu the eigenvector for the eigenvalue nearest zero",
       library_solver(NullVectorMethod::eigenvector)},
      {"mu the right singular vector of the smallest singular value",
       library_solver(NullVectorMethod::singular_vector)},
      {"mu the eigenvector for the eigenvalue nearest zero, by shift-invert",
       library_solver(NullVectorMethod::shift_invert)},
      {"mu with the last equation replaced by the moment condition",
       library_solver(NullVectorMethod::constrained)},
      {"mu by least squares with mu_0 = 1", least_squares},
      {"mu by least squares with the moment condition", least_squares_with_moment},
  };
  for (Index count = 0; count < unknowns; ++count) {
    const Index dropped = unknowns - 1 - count;  // the last equation is the usual choice
    solvers.push_back(
        {"mu with the equation l = " + std::to_string(dropped) + " dropped",
         [dropped](const VectorXd& alpha) { return without_equation(alpha, dropped); }});
  }
  return solvers;
}

// --- from a null vector to a column ---

/// sum_l l^2 mu_l = -2 over all integers l.
VectorXd scaled_by_moment(const VectorXd& mu) {
  double moment = 0;
  for (Index l = 0; l < mu.size(); ++l) moment += 2 * static_cast<double>(l * l) * mu[l];
  return mu * (-2 / moment);
}

/// (3.14); mu vanishes beyond its end.
VectorXd wavelet_coefficients(const VectorXd& mu) {
  VectorXd nu = -mu;
  for (Index l = 0; 2 * l < mu.size(); ++l) nu[l] += 8 * mu[2 * l];
  return nu;
}

VectorXd column(const Quantity& quantity, const VectorXd& null_vector) {
  const VectorXd mu = scaled_by_moment(null_vector);
  if (quantity == Quantity::mu) return mu;
  if (quantity == Quantity::mu_normalized) return mu / mu[0];
  const VectorXd nu = wavelet_coefficients(mu);
  if (quantity == Quantity::nu) return nu;
  if (quantity == Quantity::nu_normalized) return nu / nu[0];
  throw std::invalid_argument("not a connection coefficient");
}

std::vector<RouteValues> tap_routes(const Quantity& quantity, const RouteInput& input) {
  std::vector<RouteValues> routes;
  for (const auto& [name, taps] : tap_sources(input)) {
    routes.push_back({name, taps * tap_factor(quantity)});
  }
  return routes;
}

/// Empty where the solver finds no null vector, or infinities.
std::optional<VectorXd> solved_column(const Quantity& quantity, const Solver& solve,
                                      const VectorXd& alpha) {
  try {
    const VectorXd values = column(quantity, solve(alpha));
    if (values.allFinite()) return values;
  } catch (const std::domain_error&) {  // an iteration that did not converge is no route
  }
  return std::nullopt;
}

std::vector<RouteValues> coefficient_routes(const Quantity& quantity, const RouteInput& input) {
  std::vector<RouteValues> routes;
  for (const auto& [alpha_name, alpha] : alpha_sources(input)) {
    for (const auto& [solver_name, solve] : null_vector_solvers(alpha.size() - 1)) {
      const auto values = solved_column(quantity, solve, alpha);
      if (values) routes.push_back({alpha_name + "; " + solver_name, *values});
    }
  }
  return routes;
}

}  // namespace

double eigenvalue_nearest_zero(const Eigen::Ref<const MatrixXd>& a) {
  const Eigen::VectorXcd eigenvalues = MatrixXd(a).eigenvalues();
  Index nearest = 0;
  eigenvalues.cwiseAbs().minCoeff(&nearest);
  const bool is_real = eigenvalues[nearest].imag() == 0;
  return is_real ? eigenvalues[nearest].real() : std::abs(eigenvalues[nearest]);
}

std::vector<RouteValues> run_routes(const Quantity& quantity, const RouteInput& input) {
  if (is_taps(quantity)) return tap_routes(quantity, input);
  if (quantity == Quantity::autocorrelation) {
    RouteInput without_print = input;
    without_print.printed_alpha.resize(0);  // a column does not explain itself
    return alpha_sources(without_print);
  }
  const bool is_mu = quantity == Quantity::mu || quantity == Quantity::mu_normalized;
  const bool is_nu = quantity == Quantity::nu || quantity == Quantity::nu_normalized;
  if (!is_mu && !(is_nu && input.orthonormal)) return {};
  if (input.taps.size() < 3) return {};
  return coefficient_routes(quantity, input);
}

}  // namespace wavecurve::verification
