#include "wavecurve/curves/descriptor.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Contour square(double side) {
  Contour points(4, 2);
  points << 0, 0, side, 0, side, side, 0, side;
  return points;
}

Drawing two_layers() {
  Drawing drawing;
  drawing.view_box = {0, 0, 10, 10};
  drawing.layers.resize(2);
  drawing.layers[0].id = "skin";
  drawing.layers[0].subpaths = {polygon(square(8)), polygon(square(2).colwise().reverse())};
  drawing.layers[0].paint.fill = Colour{1, 0.5, 0};
  drawing.layers[1].id = "mouth";
  Subpath open = polygon(square(3));
  open.closed = false;
  open.segments.pop_back();
  drawing.layers[1].subpaths = {open};
  drawing.layers[1].paint.stroke = Colour{};
  return drawing;
}

TEST(Descriptor, HoldsWhatTheDrawingIs) {
  const Drawing drawing = two_layers();
  const DescriptorOptions options{64, 3, SampleMode::samples, Corners::kept};
  const Descriptor descriptor = describe(drawing, find_filter_bank("D8"), options);
  EXPECT_EQ(descriptor.filter, "db4");
  EXPECT_EQ(descriptor.view_box, drawing.view_box);
  ASSERT_EQ(descriptor.layers.size(), 2u);
  const LayerDescriptor& skin = descriptor.layers[0];
  EXPECT_EQ(skin.id, "skin");
  EXPECT_EQ(skin.paint, drawing.layers[0].paint);
  ASSERT_EQ(skin.contours.size(), 2u);
  EXPECT_NEAR(skin.contours[0].length, 32, 1e-11);
  EXPECT_TRUE(skin.contours[1].closed);
  const ContourDescriptor& mouth = descriptor.layers[1].contours[0];
  EXPECT_FALSE(mouth.closed);
  EXPECT_NEAR(mouth.length, 9, 1e-11);
  EXPECT_EQ(mouth.coefficients.rows(), 64);
}

TEST(Descriptor, GivesTheSamplesAgain) {
  const Drawing drawing = two_layers();
  for (const char* name : {"db4", "bspline4.4", "coif2"}) {
    const FilterBank<double> bank = find_filter_bank(name);
    for (SampleMode mode : {SampleMode::samples, SampleMode::interpolate}) {
      const DescriptorOptions options{128, 4, mode, Corners::ignored};
      const Descriptor descriptor = describe(drawing, bank, options);
      for (std::size_t i = 0; i < 2; ++i) {
        const auto expected = sample_layer(drawing.layers[i], 128);
        const auto found = reconstruct(descriptor.layers[i], bank, options, 128);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
          EXPECT_LE((found[k] - expected[k]).norm(), 1e-13 * expected[k].norm()) << name;
        }
      }
    }
  }
}

TEST(Descriptor, LiesNearTheContourAtTheCoarsestScale) {
  const Drawing drawing = two_layers();
  const FilterBank<double> bank = find_filter_bank("bspline4.4");
  const DescriptorOptions options{128, 3, SampleMode::samples, Corners::ignored};
  const Descriptor descriptor = describe(drawing, bank, options);
  const Contour full = reconstruct(descriptor.layers[0], bank, options, 128)[0];
  const Contour coarse = reconstruct(descriptor.layers[0], bank, options, 16)[0];
  const double distance = (full - coarse).rowwise().norm().maxCoeff();
  EXPECT_GT(distance, 0.01);  // corners are rounded off
  EXPECT_LT(distance, 1);     // within half of the spacing, 32 / 16
  for (Eigen::Index scale : {0, 1, 8, 24, 100, 256}) {
    EXPECT_THROW(reconstruct(descriptor.layers[0], bank, options, scale), std::invalid_argument)
        << scale;
  }
}

/// Filters that are symmetric about 0 keep the two ways together; others part them.
TEST(Descriptor, KeepsAStrokeAStrokeAtEveryScale) {
  const Drawing drawing = two_layers();
  const DescriptorOptions options{128, 4, SampleMode::samples, Corners::ignored};
  const auto gap = [&](const char* name, Eigen::Index scale) {
    const FilterBank<double> bank = find_filter_bank(name);
    const Descriptor descriptor = describe(drawing, bank, options);
    const Contour stroke = reconstruct(descriptor.layers[1], bank, options, scale)[0];
    const Contour back = stroke.bottomRows(127).colwise().reverse();
    return (stroke.bottomRows(127) - back).rowwise().norm().maxCoeff();
  };
  for (Eigen::Index scale : {8, 16, 32, 64, 128}) {
    EXPECT_LE(gap("bspline4.4", scale), 1e-11) << scale;  // as exact as the arc length
    EXPECT_LE(gap("cdf9.7", scale), 1e-11) << scale;
  }
  EXPECT_GT(gap("db4", 8), 0.01);
}

/// The shares of an orthonormal family are those of the variance, by Parseval's relation.
TEST(EnergyShares, AreThoseOfTheVariance) {
  const Contour samples = sample_contour(square(5), 64);
  const Contour coefficients = to_coefficients(find_filter_bank("db4"), samples, 3);
  const Eigen::VectorXd shares = energy_shares(coefficients, 3);
  ASSERT_EQ(shares.size(), 4);
  EXPECT_NEAR(shares.sum(), 1, 4 * epsilon);
  const double variance = (samples.rowwise() - samples.colwise().mean()).squaredNorm();
  const double finest = coefficients.bottomRows(32).squaredNorm();
  EXPECT_NEAR(shares[3], finest / variance, 64 * epsilon);
  Contour moved = samples;
  moved.rowwise() += Eigen::RowVector2d(100, -50);
  const Contour moved_coefficients = to_coefficients(find_filter_bank("db4"), moved, 3);
  EXPECT_LE((energy_shares(moved_coefficients, 3) - shares).norm(), 1e-12);
  EXPECT_TRUE(energy_shares(Contour::Zero(64, 2), 3).isZero(0));
}

}  // namespace
}  // namespace wavecurve
