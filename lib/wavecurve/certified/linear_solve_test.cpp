#include "wavecurve/certified/linear_solve.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/certified/random_numbers_test.hpp"

namespace wavecurve::certified {
namespace {

constexpr int largest = 5;

template <class Scalar>
struct System {
  SquareMatrix<Scalar> a;
  std::vector<Scalar> b;
};

/// Small fractions and zeros, with a long or far number here and there.
Rational entry(RandomNumbers& random) {
  if (random.one_in(4)) return random.rational();
  return {random.integer(-3, 3), random.integer(1, 3)};
}

System<Rational> random_system(RandomNumbers& random) {
  const int n = static_cast<int>(random.integer(1, largest));
  System<Rational> system{SquareMatrix<Rational>(n), {}};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) system.a(i, j) = entry(random);
    system.b.push_back(entry(random));
  }
  return system;
}

/// One row becomes a combination of the others.
void make_singular(RandomNumbers& random, SquareMatrix<Rational>& a) {
  const int n = a.size(), row = static_cast<int>(random.integer(0, n - 1));
  for (int j = 0; j < n; ++j) a(row, j) = 0;
  for (int i = 0; i < n; ++i) {
    const Rational factor(random.integer(-2, 2));
    for (int j = 0; j < n && i != row; ++j) a(row, j) += factor * a(i, j);
  }
}

/// By the sum over permutations; independent of any elimination.
Rational determinant(const SquareMatrix<Rational>& a) {
  std::vector<int> columns;
  for (int j = 0; j < a.size(); ++j) columns.push_back(j);
  Rational sum(0);
  do {
    Rational term(1);
    for (int i = 0; i < a.size(); ++i) {
      term *= a(i, columns[static_cast<std::size_t>(i)]);
      for (int k = 0; k < i; ++k) {
        if (columns[static_cast<std::size_t>(k)] > columns[static_cast<std::size_t>(i)])
          term = -term;
      }
    }
    sum += term;
  } while (std::next_permutation(columns.begin(), columns.end()));
  return sum;
}

Rational residual(const System<Rational>& system, const std::vector<Rational>& x, int row) {
  Rational sum = -system.b[static_cast<std::size_t>(row)];
  for (int j = 0; j < system.a.size(); ++j) {
    sum += system.a(row, j) * x[static_cast<std::size_t>(j)];
  }
  return sum;
}

/// Around the numbers of a system: exact, or of a random relative width.
System<Ball> enclose(RandomNumbers& random, const System<Rational>& system) {
  const auto widen = [&](const Rational& x) {
    if (random.one_in(2)) return Ball(x);
    // The middle is off by up to the radius, so that the number is any of the ball's.
    const Rational radius =
        (x.abs() + Rational(1)) * Rational::power_of_two(random.integer(-90, -4));
    return Ball::around(x + radius * Rational(random.integer(-3, 3), 4), radius);
  };
  System<Ball> balls{SquareMatrix<Ball>(system.a.size()), {}};
  for (int i = 0; i < system.a.size(); ++i) {
    for (int j = 0; j < system.a.size(); ++j) balls.a(i, j) = widen(system.a(i, j));
    balls.b.push_back(widen(system.b[static_cast<std::size_t>(i)]));
  }
  return balls;
}

TEST(LinearSolve, FractionsObeyTheEquationsExactly) {
  RandomNumbers random;
  int singular = 0;
  for (int i = 0; i < random_cases; ++i) {
    System<Rational> system = random_system(random);
    if (random.one_in(8)) make_singular(random, system.a);
    const auto x = solve(system.a, system.b);
    ASSERT_EQ(x.has_value(), !determinant(system.a).is_zero()) << i;
    if (!x) ++singular;
    for (int row = 0; x && row < system.a.size(); ++row) {
      ASSERT_TRUE(residual(system, *x, row).is_zero()) << i << " row " << row;
    }
  }
  EXPECT_GT(singular, random_cases / 10);
}

TEST(LinearSolve, EnclosuresHoldTheSolutionOfEverySystemInThem) {
  RandomNumbers random;
  int solved = 0;
  for (int i = 0; i < random_cases; ++i) {
    const WorkingPrecision precision(random.one_in(2) ? 64 : 256);
    const System<Rational> system = random_system(random);
    const auto exact = solve(system.a, system.b);
    const System<Ball> balls = enclose(random, system);
    const auto x = solve(balls.a, balls.b);
    if (!x) continue;
    ++solved;
    ASSERT_TRUE(exact) << i << ": regularity was claimed of an enclosure with a singular member";
    for (std::size_t k = 0; k < x->size(); ++k) {
      ASSERT_TRUE((*x)[k].contains((*exact)[k])) << i << " unknown " << k;
    }
  }
  EXPECT_GT(solved, random_cases / 4);
}

TEST(LinearSolve, ProvesNothingOfAnEnclosureWithASingularMember) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    System<Rational> system = random_system(random);
    make_singular(random, system.a);
    const System<Ball> balls = enclose(random, system);
    ASSERT_FALSE(solve(balls.a, balls.b)) << i;
  }
}

TEST(LinearSolve, LargeSystemsLoseNoMoreThanTheirConditionTakes) {
  // Hilbert's matrix, whose norm is below 4, and 2^-c on its diagonal: a condition below 2^(c + 3), up to
  // one at which an inverse in double precision says nothing any more. Rounding leaves a residual of
  // n^2 units at most (10 bits), and the solution has numbers from 1 to n (5 bits); 2 bits for the sums
  // of these bounds.
  constexpr int n = 30;
  constexpr long bits = 256, more_bits = 3 + 10 + 5 + 2;
  const WorkingPrecision precision(bits);
  for (int c = 0; c <= 44; ++c) {
    System<Ball> system{SquareMatrix<Ball>(n), {}};
    for (int i = 0; i < n; ++i) {
      Rational sum(0);
      for (int j = 0; j < n; ++j) {
        const Rational entry = Rational(1, i + j + 1) + (i == j ? Rational::power_of_two(-c) : 0);
        system.a(i, j) = Ball(entry);
        sum += entry * Rational(j + 1);
      }
      system.b.emplace_back(sum);
    }
    const auto x = solve(system.a, system.b);
    ASSERT_TRUE(x) << c;
    for (int j = 0; j < n; ++j) {
      const Ball& value = (*x)[static_cast<std::size_t>(j)];
      EXPECT_TRUE(value.contains(Rational(j + 1))) << c;
      EXPECT_GE(value.accuracy_bits(), bits - c - more_bits) << c;
    }
  }
}

TEST(LinearSolve, IsTightForDominantDiagonals) {
  RandomNumbers random;
  const WorkingPrecision precision(200);
  for (int i = 0; i < random_cases; ++i) {
    const int n = static_cast<int>(random.integer(1, 2 * largest));
    System<Ball> system{SquareMatrix<Ball>(n), {}};
    for (int row = 0; row < n; ++row) {
      for (int j = 0; j < n; ++j) {
        system.a(row, j) = Ball(row == j ? 3 * n : random.integer(-3, 3));
      }
      system.b.push_back(Ball(random.integer(-3, 3)));
    }
    const auto x = solve(system.a, system.b);
    ASSERT_TRUE(x) << i;
    for (const Ball& value : *x) ASSERT_LT(value.radius_double(), 1e-50) << i;
  }
}

TEST(LinearSolve, RefusesARightHandSideOfAnotherLength) {
  EXPECT_THROW(solve(SquareMatrix<Ball>(2), std::vector<Ball>(3)), std::invalid_argument);
  EXPECT_THROW(solve(SquareMatrix<Rational>(2), std::vector<Rational>(1)), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::certified
