#include "wavecurve/motion/gait/model/detail/fit_gammas.hpp"

#include <cmath>
#include <random>

#include <Eigen/Dense>
#include <boost/math/distributions/students_t.hpp>
#include <gtest/gtest.h>

#include "wavecurve/motion/gait/model/detail/fit_oscillator.hpp"
#include "wavecurve/motion/gait/model/detail/fit_series.hpp"
#include "wavecurve/motion/gait/model/phase_motion.hpp"

namespace wavecurve::gait {
namespace {

using Eigen::Index;

/// Runs of a motion between random key frames, with noise in frames and key frames.
PhaseData planted(const PhaseMotion& motion, Index points, int runs, int frames, double noise,
                  std::mt19937& generator) {
  std::normal_distribution<double> normal(0, 1);
  std::uniform_real_distribution<double> movement(1, 3);
  PhaseData data{"swing", {}, motion.begin, motion.end};
  for (int r = 0; r < runs; ++r) {
    Contour from(points, 2), to(points, 2);
    for (double& value : from.reshaped()) value = normal(generator);
    for (Index i = 0; i < from.size(); ++i) {
      to.reshaped()[i] = from.reshaped()[i] + movement(generator);
    }
    PhaseRun run{0,
                 1,
                 from.reshaped().transpose(),
                 to.reshaped().transpose(),
                 Eigen::VectorXd(frames),
                 Eigen::MatrixXd(frames, 2 * points)};
    for (int i = 0; i < frames; ++i) {
      run.tau[i] = (i + 1.0) / (frames + 1);
      run.points.row(i) = pose_between(motion, from, to, run.tau[i]).reshaped().transpose();
    }
    for (auto part : {run.from.reshaped(), run.to.reshaped()}) {
      for (double& value : part) value += noise * normal(generator);
    }
    for (double& value : run.points.reshaped()) value += noise * normal(generator);
    data.runs.push_back(std::move(run));
  }
  return data;
}

PhaseMotion quadratic(Index points) {
  return {GaitModel::quadratic, Eigen::MatrixXd::Random(1, 2 * points), 0, 1};
}

TEST(FitGammas, FindsPlantedOnes) {
  std::mt19937 generator(1);
  const PhaseMotion motion = quadratic(8);
  const PhaseData data = planted(motion, 8, 3, 12, 0, generator);
  const Gammas gammas = fit_gammas(data, each_coefficient(16), 0.01);
  // Values of 3, movements of at least 1: some units of rounding.
  EXPECT_LT((gammas.gamma - motion.parameters.transpose()).cwiseAbs().maxCoeff(), 1e-13);
  // The square root of a difference of sums of squares, which leaves a rounding of them.
  EXPECT_LT(gammas.standard_error.maxCoeff(), 1e-7);
}

// The closed form against a general solver of the same least squares.
TEST(FitGammas, SolveTheLeastSquares) {
  std::mt19937 generator(2);
  const PhaseData data = planted(quadratic(8), 8, 3, 12, 0.3, generator);
  Eigen::VectorXi group(16);
  for (Index i = 0; i < 16; ++i) group[i] = static_cast<int>(i % 3);
  const Gammas gammas = fit_gammas(data, group, 0);
  for (int g = 0; g < 3; ++g) {
    std::vector<double> basis, values;
    for (const PhaseRun& run : data.runs) {
      const Eigen::MatrixXd rest = off_line(run);
      for (Index j = 0; j < 16; ++j) {
        if (group[j] != g) continue;
        for (Index i = 0; i < run.tau.size(); ++i) {
          basis.push_back((run.from[j] - run.to[j]) * (run.tau[i] * run.tau[i] - run.tau[i]));
          values.push_back(rest(i, j));
        }
      }
    }
    const auto size = static_cast<Index>(basis.size());
    const Eigen::Map<Eigen::MatrixXd> a(basis.data(), size, 1);
    const Eigen::Map<Eigen::VectorXd> b(values.data(), size);
    EXPECT_NEAR(gammas.gamma[g], Eigen::VectorXd(a.colPivHouseholderQr().solve(b))[0], 1e-12);
  }
}

// Among intervals of 95 %, 95 % hold the planted gamma: n = 4000 trials, so 0.0034 standard deviation, of
// which four; and a share of (noise / movement)^2 = 1e-4 for what is not linear in the noise. An
// error bar without the noise of the key frames would hold it in 80 % or less.
TEST(FitGammas, StandardErrorsHoldAtTheirRate) {
  std::mt19937 generator(4);
  constexpr Index points = 20;
  constexpr int runs = 3, frames = 12, trials = 100;
  const PhaseMotion motion = quadratic(points);
  const boost::math::students_t distribution(runs * frames - 1);
  const double quantile = boost::math::quantile(distribution, 0.975);
  int inside = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const PhaseData data = planted(motion, points, runs, frames, 0.01, generator);
    const Gammas gammas = fit_gammas(data, each_coefficient(2 * points), 0.01);
    for (Index i = 0; i < 2 * points; ++i) {
      inside += std::abs(gammas.gamma[i] - motion.parameters(0, i)) <=
                quantile * gammas.standard_error[i];
    }
  }
  EXPECT_NEAR(inside / (2.0 * points * trials), 0.95, 4 * 0.0034);
}

// The same for one gamma of all coefficients; n = 400, standard deviation 0.011.
TEST(FitGammas, StandardErrorsOfGroupsHoldAtTheirRate) {
  std::mt19937 generator(5);
  constexpr Index points = 6;
  const PhaseMotion motion{GaitModel::quadratic_by_limb, Eigen::MatrixXd::Constant(1, 12, 0.4), 0,
                           1};
  int inside = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const PhaseData data = planted(motion, points, 3, 12, 0.01, generator);
    const Gammas gammas = fit_gammas(data, all_coefficients(12), 0.01);
    inside += std::abs(gammas.gamma[0] - 0.4) <= 1.96 * gammas.standard_error[0];
  }
  EXPECT_NEAR(inside / 400.0, 0.95, 4 * 0.011);
}

TEST(FitGammas, HasNoneForWhatDoesNotMove) {
  std::mt19937 generator(6);
  PhaseData data = planted(quadratic(4), 4, 2, 10, 0.001, generator);
  for (PhaseRun& run : data.runs) run.to[3] = run.from[3] + 1e-9;
  const Gammas gammas = fit_gammas(data, each_coefficient(8), 0.01);
  for (Index i = 0; i < 8; ++i) {
    EXPECT_EQ(std::isnan(gammas.gamma[i]), i == 3);
    EXPECT_EQ(std::isnan(gammas.standard_error[i]), i == 3);
  }
  // In a group it counts by its movement: not at all.
  EXPECT_TRUE(std::isfinite(fit_gammas(data, all_coefficients(8), 0.01).gamma[0]));
}

TEST(FitSeries, FindsPlantedPolynomials) {
  std::mt19937 generator(7);
  for (int degree = 2; degree <= 6; ++degree) {
    // Degree 2 has no model of its own name: as quadratic_by_level.
    const auto model = degree == 2 ? GaitModel::quadratic_by_level
                                   : gait_models[static_cast<std::size_t>(degree + 1)];
    const PhaseMotion motion{model, Eigen::MatrixXd::Random(degree - 1, 10), 0, 1};
    const PhaseData data = planted(motion, 5, 3, 12, 0, generator);
    // The normal equations square the basis' condition, here below 100.
    EXPECT_LT((fit_polynomial(data, degree) - motion.parameters).cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST(FitSeries, NormalEquationsAgreeWithQr) {
  std::mt19937 generator(8);
  const PhaseData swing = planted(quadratic(5), 5, 3, 14, 0.2, generator);
  PhaseData stance = planted(quadratic(5), 5, 3, 21, 0.2, generator);
  stance.begin = 0;
  stance.end = 0.6;
  PhaseData rest = swing;
  rest.begin = 0.6;
  for (int degree = 2; degree <= 6; ++degree) {
    EXPECT_LT((fit_polynomial(swing, degree) - plain::fit_polynomial(swing, degree))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-11);
  }
  EXPECT_LT((fit_fourier({stance, rest}, 9) - plain::fit_fourier({stance, rest}, 9))
                .cwiseAbs()
                .maxCoeff(),
            1e-11);
}

TEST(FitOscillator, FindsPlantedConstants) {
  std::mt19937 generator(9);
  PhaseMotion motion{GaitModel::oscillator, Eigen::MatrixXd(2, 4), 0, 1};
  motion.parameters << 1, 0.3, 3, 0.8, 2, 5, 0.7, 6;
  const PhaseData data = planted(motion, 2, 3, 12, 0, generator);
  const Eigen::MatrixXd found = fit_oscillator(data, 0.01);
  // Levenberg and Marquardt stop at a relative change of 1.5e-8 of the unknowns; their Jacobian by
  // differences, exact to 1e-8.
  EXPECT_LT((found - motion.parameters).cwiseAbs().maxCoeff(), 1e-5) << found;
}

TEST(FitOscillator, HasNoneForWhatDoesNotMove) {
  std::mt19937 generator(10);
  PhaseData data = planted(quadratic(2), 2, 2, 10, 0.001, generator);
  for (PhaseRun& run : data.runs) run.to[1] = run.from[1];
  EXPECT_TRUE(std::isnan(fit_oscillator(data, 0.01)(0, 1)));
}

}  // namespace
}  // namespace wavecurve::gait
