#include "verification/routes/routes.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "wavecurve/elementary/root.hpp"

#include "verification/routes/null_vector_routes.hpp"
#include "verification/routes/tap_rules.hpp"

namespace wavecurve::verification {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd round_to_decimals(const VectorXd& values, int decimals) {
  const double scale = whole_power(10, decimals);
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

struct NamedVector {
  std::string name;
  VectorXd values;
};

std::vector<NamedVector> tap_sources(const RouteInput& input) {
  VectorXd taps(static_cast<Index>(input.taps.size()));
  for (Index i = 0; i < taps.size(); ++i) {
    taps[i] = input.taps[static_cast<std::size_t>(i)].to_double();
  }
  std::vector<NamedVector> sources{{"the true taps", taps}};
  if (const auto& published = input.published_taps) {
    sources.push_back({"the taps of " + published->name, published->taps()});
  }
  sources.push_back({"taps in single precision", taps.cast<float>().cast<double>()});
  for (const int n : roundings(input.decimals)) {
    for (const Quantity& normalization :
         {Quantity::taps, Quantity::taps_sum_1, Quantity::taps_sum_2}) {
      const double factor = tap_factor(normalization);
      sources.push_back({to_string(normalization) + decimals_text(n),
                         round_to_decimals(taps * factor, n) / factor});
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

struct AlphaSource {
  std::string name;
  std::string taps;  ///< "alpha from ..."
  VectorXd alpha, rounding_errors;
};

/// The sum of T products of taps that carry an error of 2 u each (u = 2^-53): |error of alpha_n| <=
/// (T + 5) u times the sum of the products' magnitudes, twice.
VectorXd autocorrelation_errors(const VectorXd& taps) {
  const double operations = static_cast<double>(taps.size()) + 5;
  const double u = std::numeric_limits<double>::epsilon() / 2;
  return autocorrelation_of(taps.cwiseAbs(), false) * (operations * u);
}

std::vector<AlphaSource> alpha_sources(const RouteInput& input) {
  std::vector<AlphaSource> sources;
  if (const VectorXd& alpha = input.printed_alpha; alpha.size() > 0) {
    sources.push_back(
        {"alpha as printed", "alpha as printed", alpha, VectorXd::Zero(alpha.size())});
  }
  for (const auto& [name, taps] : tap_sources(input)) {
    const VectorXd alpha = autocorrelation_of(taps, input.orthonormal);
    const std::string from = "alpha from " + name;
    sources.push_back({from, from, alpha, autocorrelation_errors(taps)});
    sources.push_back({from + ", alpha" + decimals_text(input.decimals), from,
                       round_to_decimals(alpha, input.decimals), VectorXd::Zero(alpha.size())});
  }
  return sources;
}

// --- list 3: how the null vector is found ---

std::vector<NullVectorRoute> null_vector_routes(Index unknowns) {
  std::vector<NullVectorRoute> routes{
      {"mu the eigenvector for the eigenvalue nearest zero", NullVector::eigenvector},
      {"mu the right singular vector of the smallest singular value", NullVector::singular_vector},
      {"mu the eigenvector for the eigenvalue nearest zero, by shift-invert",
       NullVector::shift_invert},
      {"mu with the last equation replaced by the moment condition", NullVector::constrained},
      {"mu by least squares with mu_0 = 1", NullVector::least_squares},
      {"mu by least squares with the moment condition", NullVector::least_squares_with_moment},
  };
  for (Index count = 0; count < unknowns; ++count) {
    const Index dropped = unknowns - 1 - count;  // the last equation is the usual choice
    routes.push_back({"mu with the equation l = " + std::to_string(dropped) + " dropped",
                      NullVector::without_equation, dropped});
  }
  return routes;
}

std::vector<Route> alpha_routes(const RouteInput& input) {
  std::vector<Route> routes;
  for (const AlphaSource& source : alpha_sources(input)) {
    routes.push_back({source.name,
                      {source.taps},
                      Printing::rounded,
                      {},
                      {},
                      source.alpha,
                      [errors = source.rounding_errors] { return errors; }});
  }
  return routes;
}

std::vector<Route> coefficient_routes(const Quantity& quantity, const RouteInput& input) {
  std::vector<Route> routes;
  for (const AlphaSource& source : alpha_sources(input)) {
    for (const NullVectorRoute& route : null_vector_routes(source.alpha.size() - 1)) {
      const auto column = coefficient_column(quantity, source.alpha, route);
      if (!column) continue;
      routes.push_back({source.name + "; " + route.name,
                        {source.taps, route.name},
                        Printing::rounded,
                        {},
                        {},
                        *column,
                        [quantity, source, route] {
                          return coefficient_errors(quantity, source.alpha, source.rounding_errors,
                                                    route);
                        }});
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

TrueValue Route::value(std::size_t place) const {
  if (place >= static_cast<std::size_t>(doubles.size())) return {certified::Rational(0), {}};
  return exact.empty() ? exactly(doubles[static_cast<Index>(place)]) : exact[place];
}

Approximation Route::approximation(std::size_t place) const {
  if (place >= static_cast<std::size_t>(doubles.size())) return {};
  return exact.empty() ? Approximation{doubles[static_cast<Index>(place)], 0, 0}
                       : approximations[place];
}

Route rule(std::string name, std::vector<TrueValue> numbers, Printing printing) {
  Route route{name, {name}, printing, std::move(numbers), {}, {}, {}};
  route.doubles.resize(static_cast<Index>(route.exact.size()));
  for (const TrueValue& number : route.exact) {
    const Approximation approximation = approximate(number);
    route.doubles[static_cast<Index>(route.approximations.size())] = approximation.head;
    route.approximations.push_back(approximation);
  }
  return route;
}

std::vector<Route> run_routes(const Quantity& quantity, const RouteInput& input) {
  if (is_taps(quantity)) return tap_rules(quantity, input);
  if (quantity == Quantity::autocorrelation) {
    RouteInput without_print = input;
    without_print.printed_alpha.resize(0);  // a column does not explain itself
    return alpha_routes(without_print);
  }
  const bool is_mu = quantity == Quantity::mu || quantity == Quantity::mu_normalized;
  const bool is_nu = quantity == Quantity::nu || quantity == Quantity::nu_normalized;
  if (!is_mu && !(is_nu && input.orthonormal)) return {};
  if (input.taps.size() < 3) return {};
  return coefficient_routes(quantity, input);
}

}  // namespace wavecurve::verification
