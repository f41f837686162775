#include "wavecurve/operators/nonstandard_form.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/transform/plain_transform.hpp"

namespace wavecurve {
namespace {

Eigen::VectorXd some_numbers(Eigen::Index count) {
  return Eigen::VectorXd::NullaryExpr(
      count, [](Eigen::Index i) { return std::sin(1.0 + static_cast<double>(i * i)); });
}

/// Rounding: each level adds a few units times the absolute sum of its blocks, and the factors of the
/// levels, 2^-d each, add up to at most the number of levels.
double rounding(const NonstandardForm& form, Eigen::Index samples, int levels) {
  double largest = 0;
  for (const Filter<double>* block : {&form.a, &form.b, &form.c, &form.r}) {
    double sum = 0;
    for (const double value : block->taps) sum += std::abs(value);
    largest = std::max(largest, sum);
  }
  return 50 * std::numeric_limits<double>::epsilon() * (levels + 1) * largest *
         std::pow(static_cast<double>(samples), form.derivative);
}

TEST(NonstandardForm, IsTheOperatorOfTheFinestLevel) {
  for (const std::string name : {"db4", "sym6", "coif2"}) {
    const FilterBank<double> bank = find_filter_bank(name);
    for (const int derivative : {0, 1, 2}) {
      const NonstandardForm form = nonstandard_form(bank, derivative);
      for (const Eigen::Index samples : {8, 64}) {
        const Eigen::VectorXd u = some_numbers(samples), direct = apply(form, bank, u, 0);
        for (const int levels : {1, 3}) {
          const double distance = (apply(form, bank, u, levels) - direct).cwiseAbs().maxCoeff();
          EXPECT_LT(distance, rounding(form, samples, levels))
              << name << " " << derivative << " " << samples << " " << levels;
        }
      }
    }
  }
}

TEST(NonstandardForm, AgreesWithTheStandardForm) {
  // (u, T u') in wavelets by all blocks of the standard form, T = d/dx between phi and phi'.
  const FilterBank<double> bank = find_filter_bank("db4");
  const Eigen::Index samples = 64;
  const int levels = 3;
  const auto standard = multiscale_matrix(bank, samples, levels, 0, 1);
  const Eigen::VectorXd u = some_numbers(samples);
  const Eigen::VectorXd by_blocks =
      plain::inverse_transform(bank, levels, standard * plain::forward_transform(bank, levels, u));
  const NonstandardForm form = nonstandard_form(bank, 1);
  EXPECT_LT((apply(form, bank, u, levels) - by_blocks).cwiseAbs().maxCoeff(),
            2 * rounding(form, samples, levels));
}

TEST(NonstandardForm, DifferentiatesAPolynomialWhereThePeriodDoesNotShow) {
  // The shifts of phi have the coefficients l for x - M_1, whose derivative has the coefficients 1.
  const FilterBank<double> bank = find_filter_bank("db4");
  const Eigen::Index samples = 64;
  const Eigen::VectorXd line = Eigen::VectorXd::LinSpaced(samples, 0, samples - 1);
  const NonstandardForm form = nonstandard_form(bank, 1);
  const Eigen::VectorXd slope = apply(form, bank, line, 2);
  const double unit = static_cast<double>(samples);  // level J: d/dx of phi(2^J x) is 2^J phi'
  EXPECT_LT((slope.segment(32, 4).array() - unit).abs().maxCoeff(),
            rounding(form, samples, 2) * unit);
}

// The matrix acts on all wavelet and scaling coefficients; what it makes of them is put together level
// by level.
TEST(NonstandardForm, ItsMatrixIsTheSameOperator) {
  const FilterBank<double> bank = find_filter_bank("db3");
  constexpr Eigen::Index samples = 32;
  constexpr int levels = 3;
  const NonstandardForm form = nonstandard_form(bank, 1);
  const Eigen::SparseMatrix<double> matrix = nonstandard_matrix(form, samples, levels);
  ASSERT_EQ(matrix.rows(), 2 * (16 + 8 + 4));
  const Eigen::VectorXd u = some_numbers(samples);
  Eigen::VectorXd all(matrix.rows());
  Eigen::Index corner = 0;
  for (int level = levels; level >= 1; --level) {
    const Eigen::Index n = samples >> level;
    const Eigen::VectorXd parts = plain::forward_transform(bank, level, u);
    all.segment(corner, n) = parts.segment(n, n);
    all.segment(corner + n, n) = parts.head(n);
    corner += 2 * n;
  }
  const Eigen::VectorXd product = matrix * all;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(samples >> levels);
  corner = 0;
  for (int level = levels; level >= 1; --level) {
    const Eigen::Index n = samples >> level;
    Eigen::VectorXd parts(2 * n);
    parts << sum + product.segment(corner + n, n), product.segment(corner, n);
    sum = plain::inverse_transform(bank, 1, parts);
    corner += 2 * n;
  }
  EXPECT_LT((sum - apply(form, bank, u, levels)).cwiseAbs().maxCoeff(),
            2 * rounding(form, samples, levels));
}

TEST(NonstandardForm, RefusesWhatItIsNotKnownFor) {
  const FilterBank<double> bank = find_filter_bank("db4");
  EXPECT_THROW(nonstandard_form(find_filter_bank("cdf9.7"), 1), std::invalid_argument);
  EXPECT_THROW(nonstandard_form(find_filter_bank("db2"), 2), std::domain_error);
  EXPECT_THROW(nonstandard_form(bank, -1), std::invalid_argument);
  EXPECT_THROW(nonstandard_form(bank, 9), std::invalid_argument);
  EXPECT_THROW(apply(nonstandard_form(bank, 1), bank, Eigen::VectorXd::Zero(12), 3),
               std::invalid_argument);
  EXPECT_THROW(nonstandard_matrix(nonstandard_form(bank, 1), 16, 0), std::invalid_argument);
  EXPECT_THROW(nonstandard_matrix(nonstandard_form(bank, 1), 16, 5), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
