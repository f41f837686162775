#include "wavecurve/operators/nonstandard_form.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/integrals/product_integrals.hpp"
#include "wavecurve/transform/periodic_transform.hpp"
#include "wavecurve/transform/plain_transform.hpp"

namespace wavecurve {

namespace {

using Vector = Eigen::Ref<const Eigen::VectorXd>;

/// int f(x) g(x - l) dx for every l.
Filter<double> pair_integrals(const FilterBank<double>& bank, BasisFunction f, BasisFunction g) {
  ShiftTensor<double> integrals = product_integrals(bank, {{{f, false}, {g}}});
  return {integrals.first[0], std::move(integrals.values)};
}

/// sum_k block_k u_{i+k} for every i, indices modulo their number.
Eigen::VectorXd correlated(const Filter<double>& block, const Vector& u) {
  const Eigen::Index n = u.size();
  Eigen::VectorXd result = Eigen::VectorXd::Zero(n);
  for (int k = block.first_index; k <= block.last_index(); ++k) {
    const Eigen::Index start = (k % n + n) % n;
    result.head(n - start) += block[k] * u.tail(n - start);
    result.tail(start) += block[k] * u.head(start);
  }
  return result;
}

/// The product where the coefficients of the finest level are those of the given one.
Eigen::VectorXd product(const NonstandardForm& form, const FilterBank<double>& bank,
                        const Vector& finest, int levels) {
  if (levels == 0) return correlated(form.r, finest);
  const PeriodicTransform<double> transform(bank, finest.size(), 1);
  Eigen::VectorXd workspace(transform.workspace_size()), parts(finest.size());
  transform.forward(finest, parts, workspace);
  const Eigen::Index half = finest.size() / 2;
  const Eigen::VectorXd scaling = parts.head(half), wavelets = parts.tail(half);
  parts.head(half) = product(form, bank, scaling, levels - 1) + correlated(form.c, wavelets);
  parts.tail(half) = correlated(form.a, wavelets) + correlated(form.b, scaling);
  transform.inverse(parts, parts, workspace);
  // Half as many shifts are twice as far apart.
  return parts * std::ldexp(1, -form.derivative);
}

}  // namespace

NonstandardForm nonstandard_form(const FilterBank<double>& bank, int derivative) {
  if (!bank.is_orthonormal()) {
    throw std::invalid_argument("the non-standard form is one of orthonormal filters, and filter " +
                                bank.name + " is not orthonormal");
  }
  const BasisFunction phi, psi{.wavelet = true};
  const BasisFunction t_phi{.derivative = derivative},
      t_psi{.wavelet = true, .derivative = derivative};
  return {derivative, pair_integrals(bank, psi, t_psi), pair_integrals(bank, psi, t_phi),
          pair_integrals(bank, phi, t_psi), pair_integrals(bank, phi, t_phi)};
}

Eigen::VectorXd apply(const NonstandardForm& form, const FilterBank<double>& bank,
                      const Eigen::Ref<const Eigen::VectorXd>& coefficients, int levels) {
  const Eigen::Index samples = coefficients.size();
  const PeriodicTransform<double> checked(bank, samples, levels);
  const double scale = std::pow(static_cast<double>(samples), form.derivative);
  return scale * product(form, bank, coefficients, levels);
}

Eigen::SparseMatrix<double> nonstandard_matrix(const NonstandardForm& form, Eigen::Index samples,
                                               int levels) {
  check_between("number of levels of a non-standard form", levels, 1, checked_log2(samples));
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::Index corner = 0;
  for (int level = levels; level >= 1; --level) {
    const Eigen::Index n = samples >> level;
    const double scale = std::pow(static_cast<double>(n), form.derivative);
    const auto add = [&](const Filter<double>& block, Eigen::Index row, Eigen::Index column) {
      const Eigen::VectorXd values = scale * plain::periodized(block, n);
      for (Eigen::Index k = 0; k < n; ++k) {
        for (Eigen::Index i = 0; i < n && values[k] != 0; ++i) {
          entries.emplace_back(row + i, column + (i + k) % n, values[k]);
        }
      }
    };
    add(form.a, corner, corner);
    add(form.b, corner, corner + n);
    add(form.c, corner + n, corner);
    if (level == levels) add(form.r, corner + n, corner + n);
    corner += 2 * n;
  }
  Eigen::SparseMatrix<double> matrix(corner, corner);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace wavecurve
