#include "verification/identify/known_columns.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <Eigen/Core>
#include <Eigen/LU>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/lifting.hpp"
#include "wavecurve/filters/autocorrelation.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/connection_coefficients.hpp"

namespace wavecurve::verification {

namespace {

/// Adds the columns of one filter.
class FilterColumns {
 public:
  FilterColumns(std::string filter, std::vector<KnownColumn>& columns)
      : bank_(find_filter_bank(filter)), filter_(std::move(filter)), columns_(columns) {}

  void add_all() {
    add_taps();
    add("alpha", symmetric(autocorrelation(bank_.synthesis_low)));
    add_integrals();
    add_values();
    add_lifting();
  }

 private:
  void add(std::string_view quantity, Filter<double> values) {
    columns_.push_back({filter_, parse_quantity(quantity), std::move(values)});
  }

  void add_taps() {
    add("h", bank_.synthesis_low);
    add("g", bank_.synthesis_high);
    if (bank_.is_orthonormal()) return;
    add("dual(h)", bank_.analysis_low);
    add("dual(g)", bank_.analysis_high);
  }

  static Filter<double> symmetric(const Filter<double>& half) {
    Filter<double> both{-half.last_index(), {}};
    for (int n = -half.last_index(); n <= half.last_index(); ++n) {
      both.taps.push_back(half[std::abs(n)]);
    }
    return both;
  }

  static Filter<double> divided(Filter<double> values, double divisor) {
    for (double& value : values.taps) value /= divisor;
    return values;
  }

  void add_integrals() {
    add_integrals_of_order(1, 1, "mu", "nu");
    add_integrals_of_order(0, 1, "r", "int(psi(l), psi')");
    add_integrals_of_order(2, 2, "int(phi'', phi'')", "int(psi'', psi'')");
    if (bank_.is_orthonormal()) return;
    add_integrals_of_order(0, 0, "int(phi, phi)", "int(psi, psi)");
  }

  /// The first function carries the p derivatives and the shift, as in mu_l.
  void add_integrals_of_order(int p, int q, std::string_view low, std::string_view high) {
    if (!(bank_.sobolev_exponent > 0.5 * (p + q))) return;
    try {
      const auto known = connection_coefficients(bank_, p, q);
      add(low, known.mu);
      add(high, known.nu);
      if (p != 1 || q != 1) return;
      add("mu/mu0", divided(known.mu, known.mu[0]));
      add("nu/nu0", divided(known.nu, known.nu[0]));
    } catch (const std::domain_error&) {  // the integrals do not exist, or not in double precision
    }
  }

  /// phi at the integers: the eigenvector of sqrt 2 h_{2i-j} for the eigenvalue 1, whose entries
  /// add up to 1 (certified/refinable.hpp).
  void add_values() {
    constexpr double continuous = 0.5;
    const Filter<double>& h = bank_.synthesis_low;
    const int first = h.first_index + 1, n = h.size() - 2;
    if (n < 1 || !(bank_.sobolev_exponent > continuous)) return;
    Eigen::MatrixXd system(n, n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        system(i, j) = std::numbers::sqrt2 * h[first + 2 * i - j] - (i == j ? 1 : 0);
      }
    }
    system.row(n - 1).setOnes();
    const Eigen::VectorXd values = system.partialPivLu().solve(Eigen::VectorXd::Unit(n, n - 1));
    if (!values.allFinite()) return;
    add("phi", {first, {values.begin(), values.end()}});
  }

  void add_lifting() {
    if (bank_.name != "cdf9.7" && bank_.name != "bspline2.2") return;
    constexpr long bits = 64;
    const auto lifting = certified::lifting_steps(certified::find_filter(bank_.name), bits);
    Filter<double> values{0, {}};
    for (const certified::Ball& step : lifting.steps) values.taps.push_back(step.to_double());
    values.taps.push_back(lifting.factor.to_double());
    add("lifting", std::move(values));
  }

  FilterBank<double> bank_;
  std::string filter_;
  std::vector<KnownColumn>& columns_;
};

}  // namespace

const std::vector<KnownColumn>& known_columns() {
  static const std::vector<KnownColumn> columns = [] {
    std::vector<KnownColumn> result;
    for (const std::string& name : certified::filter_names()) {
      FilterColumns(name, result).add_all();
    }
    return result;
  }();
  return columns;
}

}  // namespace wavecurve::verification
