#include "wavecurve/dynamics/modal/oscillator.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::dynamics {
namespace {

using Real = boost::multiprecision::cpp_bin_float_100;
using Matrix = std::array<std::array<Real, 5>, 5>;

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      for (int k = 0; k < 5; ++k) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}

/// e^(A t) by Taylor's series of A t / 2^s, squared s times, to 50 digits and more.
Matrix exponential(Matrix a, const Real& t) {
  Real norm = 0;
  for (auto& row : a) {
    for (auto& entry : row) norm = std::max<Real>(norm, abs(entry *= t));
  }
  int squarings = 0;
  for (; norm > Real(1) / 32; norm /= 2) ++squarings;
  for (auto& row : a) {
    for (auto& entry : row) entry = ldexp(entry, -squarings);
  }
  Matrix sum{}, term{};
  for (int i = 0; i < 5; ++i) sum[i][i] = term[i][i] = 1;
  for (int n = 1; n <= 40; ++n) {
    term = product(term, a);
    for (auto& row : term) {
      for (auto& entry : row) entry /= n;
    }
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < 5; ++j) sum[i][j] += term[i][j];
    }
  }
  for (int s = 0; s < squarings; ++s) sum = product(sum, sum);
  return sum;
}

/// The exact motion of (q, q', f, g, h) with f constant (omega = 0) or (g, h) = (cos, sin) of omega t acting.
Matrix exact(const Oscillator& o, double omega, double t) {
  const Real rho = o.rho;
  Matrix a{};
  a[0][1] = 1;
  a[1][0] = -Real(o.k) / rho;
  a[1][1] = -Real(o.c) / rho;
  a[1][2] = 1 / rho;
  a[1][3] = 1 / rho;
  a[3][4] = -Real(omega);
  a[4][3] = omega;
  return exponential(a, t);
}

double error(double value, const Real& reference) {
  return static_cast<double>(abs(Real(value) - reference));
}

/// A magnitude 10^e, e uniform in -lo .. hi.
double magnitude(int lo, int hi) {
  return std::pow(10, *rc::gen::inRange(-1000 * lo, 1000 * hi) / 1000.0);
}

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The roots carry a few roundings, which a time t enlarges by |r| t; decaying parts only shrink.
double units(const Oscillator& o, double t) {
  const auto [slow, fast] = roots(o);
  return 8 * epsilon * (2 + std::abs(fast.imag()) * t + std::min(std::abs(fast.real()) * t, 50.0));
}

void expect_exact(const Oscillator& o, double t) {
  const Propagator p = propagator(o, t);
  const Matrix e = exact(o, 0, t);
  const double bound = units(o, t);
  const double k = o.k / o.rho;
  EXPECT_LE(error(p.qq, e[0][0]), bound);
  EXPECT_LE(error(p.qv, e[0][1]), bound * t);
  EXPECT_LE(error(p.vq, e[1][0]), bound * k * t);
  EXPECT_LE(error(p.vv, e[1][1]), bound);
  EXPECT_LE(error(p.qf, e[0][2]), bound * t * t / o.rho);
  EXPECT_LE(error(p.vf, e[1][2]), bound * t / o.rho);
}

RC_GTEST_PROP(Oscillator, PropagatorIsTheMatrixExponential, ()) {
  const double t = magnitude(3, 1), rho = magnitude(3, 3);
  // |r| t up to 3000: the reference is exact there too, and costs 20 squarings.
  const double frequency = magnitude(3, 2) / t, decay = magnitude(3, 2) / t;
  const Oscillator o = {rho, 2 * decay * rho, frequency * frequency * rho};
  expect_exact(o, t);
  RC_ASSERT(!testing::Test::HasFailure());
}

TEST(Oscillator, IsContinuousAcrossTheRepeatedRoot) {
  for (const double distance : {0.0, 1e-16, 1e-12, 1e-9, 1e-6, 1e-3}) {
    for (const double sign : {-1.0, 1.0}) {
      for (const double t : {1e-3, 1.0, 10.0}) {
        expect_exact({2, 4 * 3 * (1 + sign * distance), 2 * 3 * 3}, t);
        ASSERT_FALSE(HasFailure()) << distance * sign << ' ' << t;
      }
    }
  }
}

TEST(Oscillator, WithoutStiffnessOrDamping) {
  for (const double t : {0.0, 1e-8, 0.3, 40.0}) {
    expect_exact({2, 0, 0}, t);
    expect_exact({2, 0, 5}, t);
    expect_exact({2, 3, 0}, t);
  }
}

TEST(Oscillator, RootsKeepTheSmallOneExact) {
  // r^2 + 1e9 r + 1 = 0: the sum formula would leave nothing of the small root.
  const auto [slow, fast] = roots({1, 1e9, 1});
  const Real discriminant = sqrt(Real(1e18) - 4);
  EXPECT_LE(error(slow.real(), (-Real(1e9) + discriminant) / 2), 4e-9 * epsilon);
  EXPECT_LE(error(fast.real(), (-Real(1e9) - discriminant) / 2), 4e9 * epsilon);
}

RC_GTEST_PROP(Oscillator, HarmonicResponseIsTheMatrixExponential, ()) {
  const double t = magnitude(2, 1);
  const double frequency = magnitude(2, 2) / t;
  const double decay = *rc::gen::element(0.0, 1e-3, 1.0, 1.0 + 1e-9, 10.0) * frequency;
  const double ratio = *rc::gen::element(0.0, 0.3, 1.0, 1.0 + 1e-9, 5.0);  // resonance at 1
  const Oscillator o = {1, 2 * decay, frequency * frequency};
  const HarmonicResponse response = harmonic_response(o, ratio * frequency, t);
  // The column of (cos, sin)(0) = (1, 0); sin is the response to the force delayed by a quarter.
  const Matrix e = exact(o, ratio * frequency, t);
  const double bound = units(o, t) + 8 * epsilon * ratio * frequency * t;
  RC_ASSERT(error(response.q.real(), e[0][3]) <= bound * t * t);
  RC_ASSERT(error(response.v.real(), e[1][3]) <= bound * t * (1 + frequency * t));
  RC_ASSERT(error(response.q.imag(), -e[0][4]) <= bound * t * t);
}

TEST(Oscillator, PropagatorsHaveTheBitsOfEachOne) {
  std::vector<Oscillator> oscillators;
  for (int i = 0; i < 300; ++i) {
    const double k = i * i * 0.37, c = (i % 7) * 0.1;
    oscillators.push_back({i % 11 == 0 ? 0.0 : 1.0, c + (i % 11 == 0 ? 1 : 0), k});
  }
  std::vector<Propagator> all(oscillators.size());
  for (const double t : {0.0, 0.01, 1.0, 1e7}) {
    propagators(oscillators, t, all);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Propagator p = propagator(oscillators[i], t);
      const auto numbers = [](const Propagator& q) {
        return std::array{q.qq, q.qv, q.vq, q.vv, q.qf, q.vf};
      };
      EXPECT_EQ(numbers(all[i]), numbers(p)) << i << ' ' << t;
    }
  }
}

TEST(Oscillator, RefusesWhatIsNoOscillator) {
  EXPECT_THROW(propagator({0, 0, 1}, 1), std::invalid_argument);
  EXPECT_THROW(propagator({1, -1, 1}, 1), std::invalid_argument);
  EXPECT_THROW(propagator({1, 1, -1}, 1), std::invalid_argument);
  EXPECT_THROW(propagator({1, 1, 1}, -1), std::invalid_argument);
  EXPECT_THROW(propagator({1, 1, std::nan("")}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::dynamics
