#include "wavecurve/motion/morph/physical_motion.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve::motion {
namespace {

using Eigen::Index;

constexpr Index samples = 128, scale = 16;
constexpr int levels = 5;

/// A rosette of n leaves, its mean at 0 for n > 1.
Contour rosette(int n, double size = 1) {
  Contour points(samples, 2);
  for (Index i = 0; i < samples; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / samples;
    points.row(i) << std::cos(t), std::sin(t);
    points.row(i) *= size * (3 + std::cos(n * t));
  }
  return points;
}

Morph morph_of(const Contour& source, const Contour& destination, Index count = samples) {
  const auto bank = find_filter_bank("bspline4.4");
  const ContourPair pair{to_coefficients(bank, source, levels),
                         to_coefficients(bank, destination, levels)};
  return {
      {-5, -5, 10, 10}, bank, levels, Detail::blend, 0.25, 2, {{"l", {pair}, {{0, {}}}, count}}};
}

Contour frame(const Animation& animation, std::size_t index) {
  return animation.layers[0].outline[index].contours[0];
}

double largest(const Contour& displacement) { return displacement.rowwise().norm().maxCoeff(); }

// Forward and inverse transform of values up to 4 in size, sums of ten taps, 60 frames.
constexpr double rounding = 1e-12;

TEST(PhysicalMotion, BeginsWithTheSourceAndSettles) {
  Contour source = rosette(5), destination = rosette(12);
  source.rowwise() += Eigen::RowVector2d(1, -2);  // a mean, which must arrive too
  for (const Index points : {samples, scale}) {
    const Animation animation = physical_animation(morph_of(source, destination, points), {});
    ASSERT_EQ(animation.layers[0].outline.size(), 60U);
    EXPECT_EQ(animation.layers[0].outline.back().time, 2);
    EXPECT_LE(largest(frame(animation, 0) - source), rounding);
    // The synthesis filter of the spline has no negative taps: points are means of control points.
    EXPECT_LE(largest(frame(animation, 59) - destination), settled_share * 10);
    EXPECT_GE(largest(frame(animation, 30) - source), 0.5);
  }
}

// A bound of the displacement alone would be met too early, where the slowest mode passes 0.
TEST(PhysicalMotion, StaysSettled) {
  const Contour destination = rosette(3);
  const Morph morph = morph_of(rosette(2), destination);
  for (const double damping : {0.1, 0.05, 0.02, 0.01, 0.005}) {
    PhysicalOptions options;
    options.material.stiffness_damping = damping;
    options.until = 1.25 * settling_time(morph, options.material);
    options.frames = 1001;
    const Animation animation = physical_animation(morph, options);
    for (std::size_t i = 800; i <= 1000; ++i) {
      ASSERT_LE(largest(frame(animation, i) - destination), settled_share * 10) << damping << i;
    }
    EXPECT_GT(largest(frame(animation, 400) - destination), settled_share * 10) << damping;
  }
}

TEST(PhysicalMotion, MayBeMassless) {
  Contour source = rosette(2), destination = rosette(5);
  PhysicalOptions options;
  options.material = {.density = 0, .damping_density = 10};
  const Morph morph = morph_of(source, destination, scale);
  const Animation exact = physical_animation(morph, options);
  EXPECT_LE(largest(frame(exact, 59) - destination), settled_share * 10);
  options.solver = "massless-crank-nicolson";
  const Animation stepped = physical_animation(morph, options);
  EXPECT_LE(largest(frame(stepped, 59) - destination), settled_share * 10);
}

TEST(PhysicalMotion, IsLinear) {
  const Contour destination = rosette(12), displacement = rosette(5);
  PhysicalOptions options;
  options.until = 0.8;
  const Animation once = physical_animation(morph_of(destination + displacement, destination),
                                            options),
                  twice = physical_animation(morph_of(destination - 2 * displacement, destination),
                                             options);
  for (std::size_t i = 0; i < 60; ++i) {
    EXPECT_LE(largest(-2 * (frame(once, i) - destination) - (frame(twice, i) - destination)),
              rounding);
  }
}

// At a scale the control points move by the leading blocks of the matrices of all points: here by
// their eigenvectors, without damping q(t) = V cos(omega t) V^T M q(0).
TEST(PhysicalMotion, IsTheTruncatedProblemAtAScale) {
  Morph morph = morph_of(rosette(2), rosette(5), scale);
  morph.detail = Detail::drop;
  PhysicalOptions options;
  options.material = {.density = 2, .stiffness = 0.7, .bending = 0.01};
  options.until = 0.9;
  options.frames = 2;
  const Contour moved =
      to_coefficients(morph.bank, frame(physical_animation(morph, options), 1), levels);

  const dynamics::LagrangeSystem all(morph.bank, samples, levels, options.material);
  const Eigen::MatrixXd mass = Eigen::MatrixXd(all.mass()).topLeftCorner(scale, scale);
  const Eigen::MatrixXd stiffness = Eigen::MatrixXd(all.stiffness()).topLeftCorner(scale, scale);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness, mass);
  const ContourPair& pair = morph.layers[0].contours[0];
  const Eigen::MatrixXd start = (pair.source - pair.destination).topRows(scale);
  const Eigen::VectorXd cosines =
      (modes.eigenvalues().cwiseMax(0).cwiseSqrt() * *options.until).array().cos();
  const Eigen::MatrixXd expected =
      modes.eigenvectors() * cosines.asDiagonal() * modes.eigenvectors().transpose() * mass * start;
  // Eigenvalues up to 1e5 to rounding: that of the translation, 0, is less than 1e-10, its
  // cosine 1.
  EXPECT_LE(largest(moved.topRows(scale) - pair.destination.topRows(scale) - expected), 1e-9);
  EXPECT_LE(largest(moved.bottomRows(samples - scale)), rounding);
  EXPECT_GE(largest(expected - start), 1);
}

TEST(PhysicalMotion, SolversAgree) {
  const Morph morph = morph_of(rosette(2), rosette(5), scale);
  PhysicalOptions options;
  options.until = 1;
  const Animation exact = physical_animation(morph, options);
  options.solver = "coupled";
  const Animation coupled = physical_animation(morph, options);
  options.solver = "decoupled";
  const Animation decoupled = physical_animation(morph, options);
  double coupled_error = 0, decoupled_error = 0;
  for (std::size_t i = 0; i < 60; ++i) {
    coupled_error = std::max(coupled_error, largest(frame(coupled, i) - frame(exact, i)));
    decoupled_error = std::max(decoupled_error, largest(frame(decoupled, i) - frame(exact, i)));
  }
  EXPECT_LE(coupled_error, 1e-4);  // a hundred steps of 1e-6 of a displacement of 1
  EXPECT_GE(decoupled_error, 1e-2);
}

TEST(PhysicalMotion, IsThrownByAForce) {
  const Contour still = rosette(5);
  PhysicalOptions options;
  options.material = {.density = 2};
  options.until = 3;
  options.frames = 13;
  options.force << 0.5, -4;
  const Morph morph = morph_of(still, still, scale);
  const Animation animation = physical_animation(morph, options);
  for (std::size_t i = 0; i < 13; ++i) {
    const double t = 3 * static_cast<double>(i) / 12;
    const Eigen::RowVector2d fallen = t * (t - 3) / 2 * options.force / 2;
    EXPECT_LE(largest((frame(animation, i) - still).rowwise() - fallen), rounding) << i;
  }
}

TEST(PhysicalMotion, RefusesWhatIsOutOfBounds) {
  const Morph morph = morph_of(rosette(2), rosette(5));
  const auto refuses = [&](auto change, const char* text) {
    PhysicalOptions options;
    change(options);
    try {
      physical_animation(morph, options);
      ADD_FAILURE() << "took " << text;
    } catch (const std::logic_error& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  refuses([](auto& o) { o.frames = 1; }, "frames is 1");
  refuses([](auto& o) { o.until = 0.0; }, "until is 0");
  refuses([](auto& o) { o.until = NAN; }, "until is nan");
  refuses([](auto& o) { o.force[1] = INFINITY; }, "force is 0, inf");
  refuses([](auto& o) { o.solver = "magic"; }, "unknown solver 'magic'; known: spectral");
  refuses([](auto& o) { o.material.density = -1; }, "density is -1");
  refuses([](auto& o) { o.material.stiffness_damping = 0; }, "damping is 0");
  refuses([](auto& o) { o.material.stiffness_damping = 1e-9; }, "does not settle");
  refuses([](auto& o) { o.material.stiffness = 0; }, "stiffness is 0");
  refuses(
      [](auto& o) {
        o.material.density = 0;
        o.force[0] = 1;
      },
      "density is 0");
  EXPECT_THROW(physical_animation(morph_of(rosette(2), rosette(5), 7), {}), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::motion
