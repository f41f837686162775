#include "wavecurve/operators/differentiation.hpp"

#include <cmath>
#include <complex>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/basis_function.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/integrals/product_integrals.hpp"
#include "wavecurve/transform/dyadic_values.hpp"
#include "wavecurve/transform/fourier_transform.hpp"
#include "wavecurve/transform/plain_transform.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double smallest_modulus = 1e-6;

void check_arguments(Index samples, int d) {
  check_between("number of samples", samples, 1, 1 << 24);
  check_between("derivative order", d, 0, highest_derivative);
}

double to_unit_period(Index samples, int d) { return std::pow(static_cast<double>(samples), d); }

/// sum_n phi^(d)(n) e^(-2 pi i k n / N) by frequency k.
Eigen::VectorXcd symbol(const FilterBank<double>& bank, Index samples, int d) {
  const DyadicValues values = scaling_values(bank, 0, d);
  const Filter<double> at_integers{static_cast<int>(values.first),
                                   {values.values.begin(), values.values.end()}};
  Eigen::VectorXcd result = plain::periodized(at_integers, samples).cast<std::complex<double>>();
  FourierTransform(samples).forward(result);
  return result;
}

}  // namespace

VectorXd galerkin_differentiation(const FilterBank<double>& bank, Index samples, int d) {
  check_arguments(samples, d);
  const BasisFunction derivative{.derivative = d}, dual{.dual = true};
  ShiftTensor<double> r = product_integrals(bank, {{{derivative, false}, {dual}}});
  const Filter<double> all{r.first[0], std::move(r.values)};
  return to_unit_period(samples, d) * plain::periodized(all, samples);
}

VectorXd collocation_differentiation(const FilterBank<double>& bank, Index samples, int d) {
  check_arguments(samples, d);
  const Eigen::VectorXcd values = symbol(bank, samples, 0);
  const double modulus = values.cwiseAbs().minCoeff();
  if (!(modulus >= smallest_modulus)) {
    throw std::domain_error(
        fmt::format("{}: no function has given values: the smallest modulus of phi's symbol at {} "
                    "samples is {:.3g}, but must be at least {:g}",
                    bank.name, samples, modulus, smallest_modulus));
  }
  Eigen::VectorXcd quotient = symbol(bank, samples, d).cwiseQuotient(values);
  FourierTransform(samples).inverse(quotient);
  return to_unit_period(samples, d) * quotient.real();
}

Eigen::SparseMatrix<double> circulant_matrix(const Eigen::Ref<const VectorXd>& column) {
  const Index n = column.size();
  std::vector<Index> offsets;  // of a long column few are not zero
  for (Index r = 0; r < n; ++r) {
    if (column[r] != 0) offsets.push_back(r);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (Index j = 0; j < n; ++j) {
    for (const Index r : offsets) entries.emplace_back((j + r) % n, j, column[r]);
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace wavecurve
