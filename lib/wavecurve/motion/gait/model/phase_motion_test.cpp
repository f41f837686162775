#include "wavecurve/motion/gait/model/phase_motion.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "wavecurve/motion/gait/model/limb_path.hpp"

namespace wavecurve::gait {
namespace {

Eigen::Index rows_of(GaitModel model) {
  for (Eigen::Index rows : {0, 1, 2, 3, 4, 5}) {
    // The series has many possible lengths: 5, not 1.
    if (has_rows(model, rows) && (model != GaitModel::fourier || rows == 5)) return rows;
  }
  return -1;
}

struct Case {
  PhaseMotion motion;
  Contour from = Contour::Random(4, 2), to = Contour::Random(4, 2);
};

Case random_case(GaitModel model) {
  Case result;
  result.motion = {model, Eigen::MatrixXd::Random(rows_of(model), 8), 0.2, 0.7};
  if (model == GaitModel::oscillator) {
    result.motion.parameters = result.motion.parameters.cwiseAbs() * 2;
  }
  return result;
}

// Values of size 1, a few operations each.
constexpr double round_off = 1e-14;

TEST(PhaseMotion, EveryModelPassesThroughBothKeyFrames) {
  for (GaitModel model : gait_models) {
    const Case c = random_case(model);
    EXPECT_LT((pose_between(c.motion, c.from, c.to, 0) - c.from).cwiseAbs().maxCoeff(), round_off)
        << model_name(model);
    EXPECT_LT((pose_between(c.motion, c.from, c.to, 1) - c.to).cwiseAbs().maxCoeff(), round_off)
        << model_name(model);
  }
}

TEST(PhaseMotion, VelocityIsTheDerivative) {
  constexpr double step = 1e-5;
  for (GaitModel model : gait_models) {
    const Case c = random_case(model);
    for (double tau : {0.0, 0.3, 0.8, 1.0}) {
      const Contour difference = (pose_between(c.motion, c.from, c.to, tau + step) -
                                  pose_between(c.motion, c.from, c.to, std::abs(tau - step))) /
                                 (tau > 0 ? 2 * step : step);
      // One-sided at 0, where poses are not asked for before; then of first order.
      if (tau == 0) continue;
      // step^2 times third derivatives, below (2 pi 2)^3 / 6, and round-off / step.
      EXPECT_LT((velocity_between(c.motion, c.from, c.to, tau) - difference).cwiseAbs().maxCoeff(),
                1e-7)
          << model_name(model) << " at " << tau;
    }
  }
}

TEST(PhaseMotion, QuadraticIsThePublications) {
  Contour from(1, 2), to(1, 2);
  from << 3, 5;
  to << 1, 9;
  PhaseMotion motion{GaitModel::quadratic, Eigen::MatrixXd(1, 2), 0, 1};
  motion.parameters << 0.6, std::numeric_limits<double>::quiet_NaN();
  const double tau = 0.25, f = 1 - 1.6 * tau + 0.6 * tau * tau;
  const Contour pose = pose_between(motion, from, to, tau);
  EXPECT_NEAR(pose(0, 0), 1 + 2 * f, round_off);
  EXPECT_NEAR(pose(0, 1), 5 + 4 * tau, round_off);  // no gamma: a straight line
}

// f'' + e f' + k f = 0, with f = (q - q_2) / (q_1 - q_2).
TEST(PhaseMotion, OscillatorSolvesItsEquation) {
  Contour from(1, 2), to(1, 2);
  from << 1, 1;
  to << 0, 0;
  PhaseMotion motion{GaitModel::oscillator, Eigen::MatrixXd(2, 2), 0, 1};
  motion.parameters << 0.5, 4, 3, 1;
  constexpr double step = 1e-4;
  for (double tau : {0.2, 0.5, 0.9}) {
    const auto q = [&](double t) { return pose_between(motion, from, to, t); };
    const Contour second = (q(tau + step) - 2 * q(tau) + q(tau - step)) / (step * step);
    const Contour first = velocity_between(motion, from, to, tau);
    for (int i : {0, 1}) {
      // step^2 f'''' / 12 and 4 round-offs / step^2.
      EXPECT_NEAR(second(0, i) + motion.parameters(0, i) * first(0, i) +
                      motion.parameters(1, i) * q(tau)(0, i),
                  0, 1e-6);
    }
  }
}

TEST(PhaseMotion, HasNames) {
  for (GaitModel model : gait_models) EXPECT_EQ(find_gait_model(model_name(model)), model);
  EXPECT_THROW(find_gait_model("septic"), std::invalid_argument);
}

LimbPath random_path(int spans) {
  LimbPath path{"LF", 1, 0.3, {}};
  for (int i = 0; i < spans; ++i) {
    const Case c = random_case(gait_models[static_cast<std::size_t>(i + 2) % gait_models.size()]);
    path.spans.push_back({"phase", i == 0 ? 1 - 0.2 * (spans - 1) : 0.2, c.from, c.motion});
  }
  return path;
}

TEST(LimbPath, ClosesAndIsContinuous) {
  for (Continuity continuity : {Continuity::position, Continuity::velocity}) {
    const LimbPath path = random_path(3);
    double seam = path.offset;
    for (const PathSpan& span : path.spans) {
      EXPECT_LT((pose_at(path, seam, continuity) - span.start).cwiseAbs().maxCoeff(), 1e-13);
      EXPECT_LT((pose_at(path, seam - 1e-15, continuity) - span.start).cwiseAbs().maxCoeff(),
                1e-12);
      EXPECT_LT((pose_at(path, seam, continuity) - pose_at(path, seam + 1, continuity))
                    .cwiseAbs()
                    .maxCoeff(),
                1e-13);
      seam += span.share;
    }
  }
}

// The jump of the velocity at seams: with C1 none, but for the difference quotients, of first
// order.
TEST(LimbPath, HasNoCornersOnRequest) {
  const LimbPath path = random_path(4);
  constexpr double step = 1e-6;
  const auto jump = [&](double seam, Continuity continuity) {
    const auto at = [&](double u) { return pose_at(path, u, continuity); };
    return ((at(seam + step) - 2 * at(seam) + at(seam - step)) / step).cwiseAbs().maxCoeff();
  };
  double seam = path.offset;
  for (const PathSpan& span : path.spans) {
    // Second derivatives by the share of the cycle are below 1e3 here, times step.
    EXPECT_LT(jump(seam, Continuity::velocity), 5e-3);
    EXPECT_GT(jump(seam, Continuity::position), 0.1);
    seam += span.share;
  }
}

TEST(LimbPath, MovesEachPointAsThePath) {
  const LimbPath path = random_path(4), point = path_of_point(path, 2);
  for (double u : {0.0, 0.35, 0.77}) {
    EXPECT_EQ(pose_at(path, u).row(2), pose_at(point, u).row(0));
  }
}

}  // namespace
}  // namespace wavecurve::gait
