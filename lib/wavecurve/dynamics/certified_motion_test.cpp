#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve::dynamics {
namespace {

using certified::Ball;

constexpr long samples = 8;

Ball cosine(long n, long l) { return cos(Ball(2) * Ball::pi() * Ball(n * l) / Ball(samples)); }

/// q'' + s_2 k q' + k q = 0, released from 1: enclosed, below the critical damping.
Ball released(const Ball& k, const Ball& s2, const Ball& t) {
  if (k.contains_zero()) return Ball(1);
  const Ball decay = s2 * k / Ball(2);
  const Ball omega = sqrt(k - decay * decay);
  return exp(-(decay * t)) * (cos(omega * t) + decay / omega * sin(omega * t));
}

/// The displacement of a curve on the finest level, by cosines; t and all else are exact doubles.
std::vector<Ball> enclosed_motion(const Eigen::VectorXd& start, double s2, double t) {
  const auto mu = certified::connection_coefficients(certified::find_filter("db4"), 1, 1, 200).mu;
  std::vector<Ball> result(samples, Ball(0));
  for (long n = 0; n < samples; ++n) {
    Ball k = 0;
    for (int l = mu.first_index; l <= mu.last_index(); ++l) k += mu[l] * cosine(n, l);
    const Ball factor = released(n == 0 ? Ball(0) : k * Ball(samples * samples),
                                 Ball::from_double(s2), Ball::from_double(t)) /
                        Ball(samples);
    for (long j = 0; j < samples; ++j) {
      for (long i = 0; i < samples; ++i) {
        result[static_cast<std::size_t>(j)] +=
            factor * cosine(n, j - i) * Ball::from_double(start[i]);
      }
    }
  }
  return result;
}

TEST(CertifiedMotion, EnclosesTheSpectralSolution) {
  const certified::WorkingPrecision precision(256);
  const Eigen::VectorXd start = Eigen::VectorXd::Random(samples);
  for (const double s2 : {0.0, 0.0009765625}) {
    const LagrangeSystem system(find_filter_bank<double>("db4"), samples, 0,
                                {.stiffness_damping = s2});
    const InitialValueProblem problem = {
        .system = system, .initial_displacement = start, .times = Eigen::Vector3d(0.25, 1, 10)};
    const Trajectory spectral = solve_spectral(problem);
    const double fastest = std::sqrt(system.eigenvalues().stiffness.maxCoeff());
    for (std::size_t i = 0; i < 3; ++i) {
      const double t = problem.times[static_cast<Eigen::Index>(i)];
      const std::vector<Ball> exact = enclosed_motion(start, s2, t);
      // The symbols are exact to a few units, and a phase of omega t as exact as omega.
      const double bound =
          8 * std::numeric_limits<double>::epsilon() * (1 + fastest * t) * start.norm();
      for (Eigen::Index j = 0; j < samples; ++j) {
        const Ball& value = exact[static_cast<std::size_t>(j)];
        EXPECT_LT(value.radius_double(), 1e-40);
        const Ball error = abs(value - Ball::from_double(spectral.displacement[i](j, 0)));
        EXPECT_TRUE(certainly_less(error, Ball::from_double(bound))) << s2 << " " << t << " " << j;
      }
    }
  }
}

}  // namespace
}  // namespace wavecurve::dynamics
