#include "wavecurve/motion/gait/record/canine_joints.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace wavecurve::gait {
namespace {

using Eigen::Index;
using Eigen::RowVector2d;
using Eigen::VectorXd;

constexpr int frames = 200;

class EveryGait : public testing::TestWithParam<std::string> {
 protected:
  /// In the gallop a back that does not bend leaves less reach, for fast feet swing farther.
  static CanineBuild build(const std::string& gait) {
    CanineBuild dog = drawn_dog();
    if (gait == "gallop") dog.sweep = 70;
    return dog;
  }
  const CanineBuild dog = build(GetParam());
  const CanineGait gait = find_canine_gait(GetParam());
  const VectorXd phases = VectorXd::LinSpaced(frames + 1, 0, 1);
  const LimbTracks tracks = canine_joints(dog, gait, phases);

  const CanineLimb& limb(std::size_t i) const {
    return tracks.limbs[i].limb[1] == 'F' ? dog.fore : dog.hind;
  }
  /// The share of the cycle since the limb's touch-down.
  double since(std::size_t i, double phase) const {
    return phase - gait.limbs[i].touch_down - std::floor(phase - gait.limbs[i].touch_down);
  }
};

TEST_P(EveryGait, SegmentsKeepTheirLengthsAndTheThirdIsParallelToTheFirst) {
  for (std::size_t i = 0; i < 4; ++i) {
    const CanineLimb& lengths = limb(i);
    for (const Contour& joints : tracks.limbs[i].outlines) {
      EXPECT_EQ(joints.row(0), lengths.pivot);
      for (std::size_t s = 0; s < 3; ++s) {
        const auto row = static_cast<Index>(s);
        EXPECT_NEAR((joints.row(row + 1) - joints.row(row)).norm(), lengths.segments[s], 1e-11);
      }
      const RowVector2d first = joints.row(1) - joints.row(0),
                        third = joints.row(3) - joints.row(2);
      EXPECT_NEAR(first.x() * third.y() - first.y() * third.x(), 0, 1e-10);
      EXPECT_GT(first.dot(third), 0);
      const Index last = joints.rows() - 1;
      EXPECT_NEAR((joints.row(last) - joints.row(last - 1)).norm(), lengths.digits, 1e-12);
      if (lengths.metacarpus > 0) {
        EXPECT_NEAR((joints.row(4) - joints.row(3)).norm(), lengths.metacarpus, 1e-12);
      }
    }
  }
}

TEST_P(EveryGait, StandingFeetMoveWithTheGroundAndOthersAreLifted) {
  const double stride = stride_length(dog, gait);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& outlines = tracks.limbs[i].outlines;
    for (int n = 0; n < frames; ++n) {
      const auto now = static_cast<std::size_t>(n);
      const double phase = since(i, phases[n]), step = 1.0 / frames;
      const double duty = gait.limbs[i].duty_factor;
      if (phase + step < duty) {
        // The whole foot, its digits, knuckle and toe.
        const Contour moved = outlines[now + 1].bottomRows(2) - outlines[now].bottomRows(2);
        for (Index k = 0; k < 2; ++k) {
          EXPECT_NEAR((moved.row(k) - RowVector2d(-stride * step, 0)).norm(), 0, 1e-11);
        }
        EXPECT_EQ(outlines[now](outlines[now].rows() - 1, 1), dog.ground);
      } else if (phase > duty + step && phase < 1 - step) {
        EXPECT_LT(outlines[now].col(1).maxCoeff(), dog.ground);
      }
    }
  }
}

TEST_P(EveryGait, SpeedsHaveNoJumps) {
  // Second differences shrink with the square of the step where the speed is continuous, and only
  // with the step where it jumps: halving the step must divide them by more than 3.
  const auto largest = [&](int count) {
    const LimbTracks fine = canine_joints(dog, gait, VectorXd::LinSpaced(count + 1, 0, 1));
    double bound = 0;
    for (const LimbTrack& track : fine.limbs) {
      for (std::size_t j = 1; j + 1 < track.outlines.size(); ++j) {
        const Contour second =
            track.outlines[j + 1] - 2 * track.outlines[j] + track.outlines[j - 1];
        bound = std::max(bound, second.cwiseAbs().maxCoeff());
      }
    }
    return bound;
  };
  EXPECT_LT(3 * largest(800), largest(400));
}

TEST_P(EveryGait, TheCycleCloses) {
  for (const LimbTrack& track : tracks.limbs) {
    EXPECT_LT((track.outlines.back() - track.outlines.front()).cwiseAbs().maxCoeff(), 1e-10);
  }
}

std::vector<std::string> gait_names() {
  std::vector<std::string> names;
  for (const CanineGait& gait : canine_gaits()) names.push_back(gait.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Gaits, EveryGait, testing::ValuesIn(gait_names()),
                         [](const auto& gait) { return gait.param; });

TEST(CanineJoints, RightLimbsWalkAsLeftOnesHalfACycleLater) {
  const CanineGait walk = find_canine_gait("walk");
  const VectorXd phases = VectorXd::LinSpaced(33, 0, 1);
  const VectorXd later = phases.array() + 0.5;
  const LimbTracks now = canine_joints(drawn_dog(), walk, phases);
  const LimbTracks then = canine_joints(drawn_dog(), walk, later);
  for (std::size_t i = 0; i < 33; ++i) {
    for (const std::size_t left : {0U, 2U}) {
      const Contour& right = then.limbs[left + 1].outlines[i];
      EXPECT_LT((now.limbs[left].outlines[i] - right).cwiseAbs().maxCoeff(), 1e-10);
    }
  }
}

TEST(CanineJoints, TheSwingIsSlowFastSlow) {
  const CanineBuild dog = drawn_dog();
  const CanineGait walk = find_canine_gait("walk");
  const double duty = walk.limbs[0].duty_factor;
  const VectorXd phases = VectorXd::LinSpaced(101, duty, 1);
  const LimbTracks swing = canine_joints(dog, walk, phases);
  const auto speed = [&](std::size_t i) {
    const auto& toe = swing.limbs[0].outlines;
    return toe[i + 1](5, 0) - toe[i](5, 0);
  };
  EXPECT_GT(speed(50), speed(20));
  EXPECT_GT(speed(20), speed(5));
  EXPECT_GT(speed(50), speed(80));
  EXPECT_GT(speed(80), speed(95));
  double highest = dog.ground;
  for (const Contour& joints : swing.limbs[0].outlines) highest = std::min(highest, joints(5, 1));
  EXPECT_NEAR(dog.ground - highest, dog.clearance, 1e-9);
}

TEST(CanineJoints, ThePublishedProportionsAreKept) {
  const CanineLimb fore = drawn_dog().fore;
  const double length =
      fore.segments[0] + fore.segments[1] + fore.segments[2] + fore.metacarpus + fore.digits;
  EXPECT_NEAR(fore.segments[1] / length, 0.27, 0.005);
  EXPECT_GE(fore.segments[0] / length, 0.24);
  EXPECT_LE(fore.segments[0] / length, 0.34);
  EXPECT_EQ(fore.pivot.y(), drawn_dog().hind.pivot.y());
}

TEST(CanineJoints, AFootOutOfReachIsRefused) {
  CanineBuild dog = drawn_dog();
  dog.sweep = 500;
  EXPECT_THROW(canine_joints(dog, find_canine_gait("walk"), VectorXd::Zero(1)), std::domain_error);
}

}  // namespace
}  // namespace wavecurve::gait
