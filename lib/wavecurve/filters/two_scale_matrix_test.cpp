#include "wavecurve/filters/two_scale_matrix.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"

namespace wavecurve {
namespace {

using certified::Ball;
using certified::Rational;

template <class Scalar>
Filter<Scalar> converted(const Filter<Rational>& exact) {
  return {0, {exact.taps.begin(), exact.taps.end()}};
}

template <>
Filter<double> converted(const Filter<Rational>& exact) {
  Filter<double> result{0, {}};
  for (const Rational& x : exact.taps) result.taps.push_back(Ball(x).to_double());
  return result;
}

/// The right-hand side of (3.10) at l minus mu_l, as it stands there.
Rational equation(const Filter<Rational>& alpha, const Filter<Rational>& mu, int l, int d) {
  Rational sum(0);
  for (int k = -alpha.last_index(); k <= alpha.last_index(); ++k) {
    sum += alpha[k < 0 ? -k : k] * mu[2 * l + k];
  }
  return sum * Rational::power_of_two(d - 1) - mu[l];
}

/// Any sequence with the symmetry of mu, -(P-1) .. P-1; the unknowns are its second half.
Filter<Rational> some_sequence(int support, int d) {
  Filter<Rational> mu{1 - support, {}};
  for (int l = 1 - support; l < support; ++l) {
    const Rational value(l * l + 3, 2 + (l < 0 ? -l : l));
    mu.taps.push_back(d % 2 == 0 ? value : (l < 0 ? -value : Rational(l == 0 ? 0 : 1) * value));
  }
  return mu;
}

TEST(TwoScaleMatrix, IsTheEquationsOfThePublication) {
  for (const char* name : {"db1", "db3", "db8", "bspline4.4"}) {
    const auto alpha = certified::find_filter(name).exact->synthesis;
    const int support = alpha.size() - 1;
    for (int d = 0; d <= 16; ++d) {
      const int first = first_two_scale_unknown(d);
      if (support <= first) continue;
      const auto a = two_scale_matrix(alpha, d);
      ASSERT_EQ(a.size(), support - first);
      const auto mu = some_sequence(support, d);
      for (int row = 0; row < a.size(); ++row) {
        Rational product(0);
        for (int j = 0; j < a.size(); ++j) product += a(row, j) * mu[first + j];
        EXPECT_EQ(product, equation(alpha, mu, first + row, d)) << name << " " << d << " " << row;
      }
    }
  }
}

TEST(TwoScaleMatrix, HasMuForItsNullVector) {
  const auto definition = certified::find_filter("db7");
  for (const auto& [p, q] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 1}, std::pair{1, 2}}) {
    const auto mu = certified::exact_connection_coefficients(definition, p, q)->mu;
    const auto a = two_scale_matrix(definition.exact->synthesis, p + q);
    for (int row = 0; row < a.size(); ++row) {
      Rational product(0);
      for (int j = 0; j < a.size(); ++j) {
        product += a(row, j) * mu[first_two_scale_unknown(p + q) + j];
      }
      EXPECT_TRUE(product.is_zero()) << p << q << " " << row;
    }
  }
}

TEST(TwoScaleMatrix, IsTheSameForEveryScalar) {
  const auto exact = certified::find_filter("bspline4.4").exact->synthesis;  // dyadic: no rounding
  for (const int d : {0, 1, 2, 5}) {
    const auto a = two_scale_matrix(exact, d);
    const auto doubles = two_scale_matrix(converted<double>(exact), d);
    const auto balls = two_scale_matrix(converted<Ball>(exact), d);
    for (int i = 0; i < a.size(); ++i) {
      for (int j = 0; j < a.size(); ++j) {
        EXPECT_EQ(Ball::from_double(doubles(i, j)), Ball(a(i, j)));
        EXPECT_EQ(balls(i, j), Ball(a(i, j)));
      }
    }
  }
}

TEST(TwoScaleMatrix, RefusesBadInput) {
  const Filter<double> one{0, {2}}, two{0, {2, 1}}, eight{0, std::vector<double>(8, 1.0)};
  EXPECT_THROW(two_scale_matrix(one), std::invalid_argument);
  EXPECT_THROW(two_scale_matrix(two, 1), std::invalid_argument);
  EXPECT_THROW(two_scale_matrix(eight, -1), std::invalid_argument);
  EXPECT_THROW(two_scale_matrix(eight, 17), std::invalid_argument);
  EXPECT_EQ(two_scale_matrix(two, 0).size(), 1);
}

}  // namespace
}  // namespace wavecurve
