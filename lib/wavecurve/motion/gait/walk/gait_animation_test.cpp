#include "wavecurve/motion/gait/walk/gait_animation.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/motion/detail/check_animation.hpp"
#include "wavecurve/motion/gait/model/fit_gait.hpp"
#include "wavecurve/motion/gait/record/planted_gait_test.hpp"

namespace wavecurve::gait {
namespace {

GaitParameters planted_parameters(double facing = 1) {
  PlantedGait plan;
  plan.facing = facing;
  GaitFitOptions options{find_filter_bank("bspline4.4"), "bspline4.4"};
  options.scale = 32;
  return fit_gait(plan.tracks(), options).parameters;
}

/// A drawing with longer limbs than the planted animal's, standing at height 100, and a body.
Drawing dog(double facing = 1) {
  PlantedGait plan;
  plan.facing = facing;
  plan.length = 90;
  Drawing drawing{{-100, 0, 300, 120}, {}};
  Paint paint;
  paint.fill = Colour{};
  const auto add = [&](const std::string& id, Contour outline) {
    outline.col(1).array() += 100;
    drawing.layers.push_back({id, {polygon(outline)}, paint});
  };
  for (std::size_t l = 0; l < 4; ++l) add(std::string(limb_names[l]), plan.rest(l));
  Contour body(4, 2);
  body << -20, -110, 80, -110, 80, -70, -20, -70;
  add("BODY", body);
  return drawing;
}

GaitAnimationOptions some_options() {
  GaitAnimationOptions options{find_filter_bank("bspline4.4")};
  options.frames = 48;
  options.samples = 64;
  return options;
}

double distance(const std::vector<Contour>& a, const std::vector<Contour>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, (a[i] - b[i]).cwiseAbs().maxCoeff());
  }
  return most;
}

TEST(GaitAnimation, ClosesAndIsAnAnimation) {
  GaitAnimationOptions options = some_options();
  options.cycles = 3;
  options.cycle_duration = 0.8;
  const motion::Animation walk = animate_gait(planted_parameters(), dog(), options).animation;
  EXPECT_NO_THROW(motion::check_animation(walk));
  EXPECT_DOUBLE_EQ(walk.duration, 2.4);
  ASSERT_EQ(walk.layers.size(), 5U);
  for (const motion::AnimatedLayer& layer : walk.layers) {
    ASSERT_EQ(layer.outline.size(), 49U);
    EXPECT_EQ(distance(layer.outline.front().contours, layer.outline.back().contours), 0);
    // Three cycles in 48 frames: every 16th is the same but for rounding.
    EXPECT_LT(distance(layer.outline[5].contours, layer.outline[21].contours), 1e-9);
    // From frame to frame a foot moves by its way in a swing, 2 reach * 1.5, in 0.38 * 16 frames,
    // at twice the mean speed at most.
    for (std::size_t i = 0; i + 1 < 49; ++i) {
      EXPECT_LT(distance(layer.outline[i].contours, layer.outline[i + 1].contours),
                2 * 60 / (0.38 * 16));
    }
  }
}

// Standing feet move as the ground does: measured anew, from the frames of the animation alone.
TEST(GaitAnimation, StandingFeetDoNotSlide) {
  for (const CanineGait& gait : canine_gaits()) {
    GaitAnimationOptions options = some_options();
    options.gait = gait;
    options.frames = 100;
    const GaitAnimation walk = animate_gait(planted_parameters(), dog(), options);
    EXPECT_LT(walk.slide, 1e-12) << gait.name;
    EXPECT_LT(walk.lift, 1e-12) << gait.name;
    EXPECT_GT(walk.stride, 0) << gait.name;
    for (std::size_t l = 0; l < 4; ++l) {
      const auto& keys = walk.animation.layers[l].outline;
      int standing = 0;
      for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const Contour &now = keys[i].contours[0], &next = keys[i + 1].contours[0];
        Eigen::Index foot = 0;
        const double height = now.col(1).maxCoeff(&foot);
        EXPECT_LT(height, 100 + 1e-9) << gait.name;
        if (height < 100 - 1e-9 || next.col(1).maxCoeff() < 100 - 1e-9) continue;
        // The lowest point is near the foot, which moves by a 100th of the stride.
        if (std::abs(now(foot, 0) - walk.stride / 100 - next(foot, 0)) < 0.003 * walk.stride) {
          ++standing;
        }
      }
      // Counted over 100 frames, but for the ends, and for touching the ground in the swing.
      EXPECT_NEAR(standing, 100 * gait.limbs[l].duty_factor, 7) << gait.name << limb_names[l];
    }
  }
}

TEST(GaitAnimation, IsMirroredForTheOtherSide) {
  const motion::Animation right =
      animate_gait(planted_parameters(1), dog(1), some_options()).animation;
  // The record looks left, the drawing right; and the record right, the drawing left.
  const motion::Animation of_left =
      animate_gait(planted_parameters(-1), dog(1), some_options()).animation;
  const motion::Animation left =
      animate_gait(planted_parameters(1), dog(-1), some_options()).animation;
  for (std::size_t i = 0; i < right.layers.size(); ++i) {
    for (std::size_t k = 0; k < right.layers[i].outline.size(); ++k) {
      const Contour& a = right.layers[i].outline[k].contours[0];
      const Contour& b = of_left.layers[i].outline[k].contours[0];
      const Contour& c = left.layers[i].outline[k].contours[0];
      // The mirrored ellipse has its points at other places.
      EXPECT_NEAR(a.col(0).mean(), b.col(0).mean(), 0.5);
      EXPECT_NEAR(a.col(1).mean(), b.col(1).mean(), 0.5);
      if (i < 4) {
        EXPECT_NEAR(a.col(0).mean(), -c.col(0).mean(), 0.5);
      }
    }
  }
}

TEST(GaitAnimation, ByFewControlPointsIsSmoother) {
  GaitAnimationOptions options = some_options();
  const motion::Animation fine = animate_gait(planted_parameters(), dog(), options).animation;
  options.scale = 4;
  const motion::Animation coarse = animate_gait(planted_parameters(), dog(), options).animation;
  EXPECT_GT(distance(fine.layers[4].outline[3].contours, coarse.layers[4].outline[3].contours), 1);
  options.scale = 64;
  const motion::Animation same = animate_gait(planted_parameters(), dog(), options).animation;
  EXPECT_EQ(distance(fine.layers[4].outline[3].contours, same.layers[4].outline[3].contours), 0);
}

TEST(GaitAnimation, RefusesWhatItCannotMove) {
  const GaitParameters parameters = planted_parameters();
  Drawing lame = dog();
  lame.layers.erase(lame.layers.begin() + 1);
  try {
    animate_gait(parameters, lame, some_options());
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "the drawing has no layer 'RF', but the gait moves LF, RF, LH and RH");
  }
  GaitAnimationOptions options = some_options();
  options.frames = 1;
  EXPECT_THROW(animate_gait(parameters, dog(), options), std::invalid_argument);
  options = some_options();
  options.cycles = 0;
  EXPECT_THROW(animate_gait(parameters, dog(), options), std::invalid_argument);
  options = some_options();
  options.cycle_duration = 0;
  EXPECT_THROW(animate_gait(parameters, dog(), options), std::invalid_argument);
  options = some_options();
  options.scale = 5;
  EXPECT_THROW(animate_gait(parameters, dog(), options), std::invalid_argument);
  GaitParameters no_hind = parameters;
  std::erase_if(no_hind.limbs, [](const LimbPath& path) { return path.limb[1] == 'H'; });
  EXPECT_THROW(animate_gait(no_hind, dog(), some_options()), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::gait
