// -u'' = x^5 on (0, 1), u(0) = u(1) = 0, by Galerkin's method in those phi(x / h - l) that meet the interval; their integrals
// over it are proper connection coefficients. The solution is (x - x^7) / 42. Prints the error of u' in L2 for h = 1/16 to
// 1/128, whose order is N - 1 for N vanishing moments:
//   db3: 1.9e-03 5.5e-04 1.5e-04 3.8e-05, order 1.9 +- 0.1
//   db4: 2.2e-04 3.2e-05 4.2e-06 5.4e-07, order 2.9 +- 0.1
#include <Eigen/LU>

#include "galerkin.hpp"

using wavecurve::BasisFunction;
using wavecurve::product_integrals;

/// K c + B^T p = f, B c = 0: stiffness and load, and Lagrange's multipliers p that hold the ends.
struct LinearSystem {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
};

static LinearSystem assemble(const wavecurve::FilterBank<double>& bank, int n) {
  // int_0^n phi'(y - l) phi'(y - m) dy and int_0^n y^5 phi(y - l) dy, y = x / h, n = 1 / h
  const wavecurve::DyadicInterval whole{.first = 0, .last = n};
  const BasisFunction f, slope{.derivative = 1};
  const auto stiffness =
      product_integrals(bank, {.factors = {{slope}, {slope}}, .interval = whole});
  const auto load = product_integrals(bank, {.factors = {{f}}, .power = 5, .interval = whole});
  const auto phi = wavecurve::scaling_values(bank, 0);  // at the integers
  const int size = load.sizes[0], first = load.first[0];
  LinearSystem system{Eigen::MatrixXd::Zero(size + 2, size + 2), Eigen::VectorXd::Zero(size + 2)};
  for (int l = 0; l < size; ++l) {
    system.right[l] = load.at({first + l}) / std::pow(n, 6);
    for (int m = 0; m < size; ++m) {
      system.matrix(l, m) = n * stiffness.at({first + l, first + m});
    }
    for (const int end : {0, 1}) {
      const Eigen::Index place = end * n - (first + l) - static_cast<Eigen::Index>(phi.first);
      if (place < 0 || place >= phi.values.size()) continue;
      system.matrix(size + end, l) = system.matrix(l, size + end) = phi.values[place];
    }
  }
  return system;
}

int main() {
  const double energy =
      36.0 / 13 / (42 * 42);  // int u'^2; that of the error is the difference of both
  const std::vector<int> counts{16, 32, 64, 128};
  for (const char* name : {"db3", "db4"}) {
    std::vector<double> errors;
    for (const int n : counts) {
      const auto [matrix, right] = assemble(wavecurve::find_filter_bank(name), n);
      const Eigen::VectorXd c = matrix.fullPivLu().solve(right);
      errors.push_back(std::sqrt(energy - right.dot(c)));
    }
    galerkin::print_order(name, counts, errors);
  }
}
