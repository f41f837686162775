#include "wavecurve/motion/gait/record/canine_gaits.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace wavecurve::gait {
namespace {

double standing(const CanineGait& gait, double u) {
  return static_cast<double>(
      std::count_if(gait.limbs.begin(), gait.limbs.end(), [&](const LimbTiming& limb) {
        const double since = u - limb.touch_down;
        return since - std::floor(since) < limb.duty_factor;
      }));
}

TEST(CanineGaits, AllButTheGallopAreSymmetrical) {
  for (const CanineGait& gait : canine_gaits()) {
    if (gait.name == "gallop") continue;
    for (std::size_t pair : {0U, 2U}) {
      const double lag = gait.limbs[pair + 1].touch_down - gait.limbs[pair].touch_down;
      EXPECT_NEAR(std::abs(lag), 0.5, 1e-12) << gait.name;
      EXPECT_EQ(gait.limbs[pair + 1].duty_factor, gait.limbs[pair].duty_factor) << gait.name;
    }
  }
}

// What the sources say of how many feet stand.
TEST(CanineGaits, StandAsTheSourcesSay) {
  constexpr int steps = 1000;
  const auto share = [&](const char* name, double feet) {
    int count = 0;
    for (int i = 0; i < steps; ++i) {
      count += standing(find_canine_gait(name), (i + 0.5) / steps) == feet;
    }
    return count / static_cast<double>(steps);
  };
  EXPECT_EQ(share("walk", 2) + share("walk", 3), 1);
  for (const char* run : {"trot", "pace"}) {
    EXPECT_NEAR(share(run, 0), 0.1, 1e-9) << run;
    EXPECT_NEAR(share(run, 2), 0.9, 1e-9) << run;
  }
  EXPECT_GT(share("gallop", 0), 0.15);
  EXPECT_GT(share("walk", 3), 0.45);
}

TEST(CanineGaits, NamesThoseThatThereAre) {
  try {
    find_canine_gait("tort");
    FAIL();
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("unknown gait 'tort'; known: walk, trot, ")) << message;
    for (const CanineGait& gait : canine_gaits()) {
      EXPECT_NE(message.find(gait.name, message.find("known")), std::string::npos) << gait.name;
    }
  }
}

}  // namespace
}  // namespace wavecurve::gait
