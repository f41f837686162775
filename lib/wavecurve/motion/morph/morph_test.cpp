#include "wavecurve/motion/morph/morph.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/motion/morph/contour_morph.hpp"
#include "wavecurve/transform/plain_transform.hpp"

namespace wavecurve::motion {
namespace {

using Eigen::Index;

constexpr Index samples = 128, scale = 16;
constexpr int levels = 5;

/// A rosette of n leaves.
Contour rosette(int n) {
  Contour points(samples, 2);
  for (Index i = 0; i < samples; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / samples;
    points.row(i) << (3 + std::cos(n * t)) * std::cos(t), (3 + std::cos(n * t)) * std::sin(t);
  }
  return points;
}

Contour coefficients(const FilterBank<double>& bank, const Contour& points) {
  Contour result(samples, 2);
  for (int axis = 0; axis < 2; ++axis) {
    result.col(axis) = plain::forward_transform<double>(bank, levels, points.col(axis));
  }
  return result;
}

Contour points_of(const FilterBank<double>& bank, const Contour& coefficients) {
  Contour result(samples, 2);
  for (int axis = 0; axis < 2; ++axis) {
    result.col(axis) = plain::inverse_transform<double>(bank, levels, coefficients.col(axis));
  }
  return result;
}

Contour without_details(Contour coefficients) {
  coefficients.bottomRows(samples - scale).setZero();
  return coefficients;
}

Contour without_coarse(Contour coefficients) {
  coefficients.topRows(scale).setZero();
  return coefficients;
}

struct Fixture {
  FilterBank<double> bank = find_filter_bank("bspline4.4");
  Contour source = rosette(5), destination = rosette(12);
  ContourPair pair{coefficients(bank, source), coefficients(bank, destination)};

  Morph morph(Detail detail, double share = 0.25) const {
    return {{0, 0, 8, 8}, bank, levels, detail, share, 2, {{"flower", {pair}, {{0, {}}}, scale}}};
  }
};

double distance(const Contour& a, const Contour& b) { return (a - b).cwiseAbs().maxCoeff(); }

// Forward and inverse transform of values up to 4 in size, four levels' worth of sums of ten taps.
constexpr double rounding = 1e-13;

TEST(Animate, BothEndsAreExactWithDetails) {
  const Fixture f;
  for (const Detail detail : {Detail::blend, Detail::stage}) {
    const Animation animation = animate(f.morph(detail));
    EXPECT_LT(distance(frame_at(animation, 0)[0].contours[0], f.source), rounding);
    EXPECT_LT(distance(frame_at(animation, 2)[0].contours[0], f.destination), rounding);
    EXPECT_EQ(animation.layers[0].outline.size(), detail == Detail::stage ? 4u : 2u);
  }
}

TEST(Animate, WithoutDetailsTheControlPointsAreInterpolated) {
  const Fixture f;
  const Animation animation = animate(f.morph(Detail::drop));
  for (const double tau : {0.0, 0.1, 0.5, 0.7, 1.0}) {
    const Contour mixed = (1 - tau) * f.pair.source + tau * f.pair.destination;
    const Contour expected = points_of(f.bank, without_details(mixed));
    EXPECT_LT(distance(frame_at(animation, 2 * tau)[0].contours[0], expected), rounding) << tau;
  }
}

TEST(Animate, StagedDetailsFadeOutThenIn) {
  const Fixture f;
  const Animation animation = animate(f.morph(Detail::stage, 0.2));
  const auto expect_details = [&](double tau, double source_share, double destination_share) {
    const Contour coarse = without_details((1 - tau) * f.pair.source + tau * f.pair.destination);
    const Contour details =
        without_coarse(source_share * f.pair.source + destination_share * f.pair.destination);
    EXPECT_LT(
        distance(frame_at(animation, 2 * tau)[0].contours[0], points_of(f.bank, coarse + details)),
        rounding)
        << tau;
  };
  expect_details(0.1, 0.5, 0);
  expect_details(0.2, 0, 0);
  expect_details(0.5, 0, 0);
  expect_details(0.95, 0, 0.75);
}

TEST(Animate, EqualsItsFrames) {
  const Fixture f;
  for (const Detail detail : {Detail::drop, Detail::blend, Detail::stage}) {
    for (const double share : {0.25, 0.5}) {
      const Animation animation = animate(f.morph(detail, share));
      ContourMorph contour(f.bank, samples, levels, scale);
      for (int i = 0; i <= 20; ++i) {
        const double tau = i / 20.0;
        Contour points(samples, 2);
        contour.frame(f.pair, tau, detail_shares(detail, share, tau), points);
        EXPECT_LT(distance(frame_at(animation, 2 * tau)[0].contours[0], points), rounding) << tau;
      }
    }
  }
}

TEST(Animate, RefusesWhatDoesNotFit) {
  const Fixture f;
  for (const Index bad : {Index{0}, Index{3}, Index{2}, Index{256}}) {
    Morph morph = f.morph(Detail::drop);
    morph.layers[0].scale = bad;
    try {
      animate(morph);
      FAIL() << bad;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("layer 'flower'"), std::string::npos);
    }
  }
  for (const double bad : {0.0, -1.0, 0.6, std::nan("")}) {
    EXPECT_THROW(animate(f.morph(Detail::stage, bad)), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace wavecurve::motion
