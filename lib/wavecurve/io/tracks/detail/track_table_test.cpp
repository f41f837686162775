#include "wavecurve/io/tracks/detail/track_table.hpp"

#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"

namespace wavecurve::io {
namespace {

/// A limb of four points; x counts frames and points.
std::string square(int frame, const std::string& limb = "LF") {
  std::string text;
  for (int k = 0; k < 4; ++k) {
    text += std::to_string(frame) + "," + limb + "," + std::to_string(k) + "," +
            std::to_string(10 * frame + k) + "," + std::to_string(k % 2) + "\n";
  }
  return text;
}

const std::string header = "frame,limb,k,x,y\n";

std::string refused(const std::string& text, const std::vector<std::string>& limbs = {}) {
  return test::refusal([&] { read_track_table(text, limbs); });
}

TEST(TrackTable, PointsAreReadInAnyOrder) {
  const TrackTable plain = read_track_table(header + square(0) + square(1), {});
  EXPECT_FALSE(plain.joints);
  EXPECT_EQ(plain.tracks.times, Eigen::Vector2d(0, 1));
  ASSERT_EQ(plain.tracks.limbs.size(), 1U);
  EXPECT_EQ(plain.tracks.limbs[0].limb, "LF");
  Contour second(4, 2);
  second << 10, 0, 11, 1, 12, 0, 13, 1;
  EXPECT_EQ(plain.tracks.limbs[0].outlines.at(1), second);
  const TrackTable other = read_track_table(
      "\xef\xbb\xbf# made by hand\n\ny;x;k;limb;frame\n1;11;1;LF;1\n0;10;0;LF;1\n1;13;3;LF;1\n"
      "0;12;2;LF;1 # out of order\n0;0;0;LF;0\n1;1;1;LF;0\r\n0;2;2;LF;0\n1;3;3;LF;0",
      {});
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(other.tracks.limbs.at(0).outlines.at(i), plain.tracks.limbs[0].outlines[i]);
  }
}

TEST(TrackTable, ColumnsAreFoundByName) {
  const std::string rows =
      "7,0.5,LF,hip,1,2,3,1\n7,0.5,LF,toe,4,5,6,0\n"
      "9,0.9,LF,toe,7,8,9,1\n9,0.9,LF,hip,10,11,12,1\n";
  const TrackTable table =
      read_track_table("frame,t,limb,joint,x_world_m,y_m,x_treadmill_m,visible\n" + rows, {});
  EXPECT_TRUE(table.joints);
  EXPECT_TRUE(table.treadmill);
  EXPECT_EQ(table.tracks.times, Eigen::Vector2d(0.5, 0.9));
  Contour second(2, 2);
  second << 12, 11, 9, 8;
  EXPECT_EQ(table.tracks.limbs.at(0).outlines.at(1), second);
  const TrackTable world =
      read_track_table("frame,t,contour,joint,x_world_m,y_m,other,visible\n" + rows, {});
  EXPECT_FALSE(world.treadmill);
  EXPECT_EQ(world.tracks.limbs.at(0).outlines.at(0)(0, 0), 1);
}

TEST(TrackTable, OnlyTheLimbsThatAreAskedForAreLookedAt) {
  const std::string text = header + square(0) + square(1) + square(1, "RF") + "1,RF,no,x,y\n";
  EXPECT_EQ(read_track_table(text, {"LF"}).tracks.limbs.size(), 1U);
  EXPECT_EQ(refused(text, {"LF", "LH"}), "unknown limb 'LH'; known: LF");
}

TEST(TrackTable, WhatIsMissingIsNamed) {
  EXPECT_EQ(refused(""), "0 frames of the limbs to be read; at least 2 are needed");
  EXPECT_EQ(refused(header + square(3)), "1 frame of the limbs to be read; at least 2 are needed");
  EXPECT_EQ(refused("# x\nframe,limb,k,x\n"), "line 2: 'frame,limb,k,x' has no column y");
  EXPECT_EQ(refused("0,LF,0,1,2\n"), "line 1: '0,LF,0,1,2' has no column frame");
  EXPECT_EQ(refused("frame,limb,x,y\n"), "line 1: 'frame,limb,x,y' has no column k or joint");
  EXPECT_EQ(refused(header + square(0) + square(1) + square(1, "RF")),
            "limb RF is not in frame 0, but in others; it must be in all");
  EXPECT_EQ(refused(header + square(0) + square(0, "RF") + square(1)),
            "limb RF is not in frame 1, but in others; it must be in all");
  EXPECT_EQ(refused(header + square(0) + square(1) + square(3)),
            "frame 2 is missing: after 1 comes 3; uneven frames need a column t");
  EXPECT_EQ(refused(header + square(0) + "1,LF,0,1,2\n1,LF,1,1,2\n1,LF,2,1,3\n"),
            "line 6: limb LF has 3 points in frame 1; at least 4 are needed");
  EXPECT_EQ(refused(header + square(0) + "1,LF,0,1,2\n1,LF,2,1,2\n"),
            "line 7: k is 2 in limb LF, frame 1, but must be 1: 0, 1, 2, ... once each");
  EXPECT_EQ(refused(header + square(0) + square(1) + "1,LF,2,5,5\n"),
            "line 10: k is 2 in limb LF, frame 1, but must be 3: 0, 1, 2, ... once each");
}

TEST(TrackTable, JointsMustBeThoseOfTheFirstFrame) {
  const std::string joints = "frame,limb,joint,x,y\n0,LF,hip,0,0\n0,LF,toe,0,1\n";
  EXPECT_EQ(refused(joints + "1,LF,hip,0,0\n"),
            "line 4: limb LF has 1 joint; at least 2 are needed");
  EXPECT_EQ(refused(joints + "1,LF,hip,0,0\n1,LF,toe,1,1\n1,LF,knee,1,1\n"),
            "line 4: limb LF has 3 joints in frame 1, but 2 in the first frame");
  EXPECT_EQ(refused(joints + "1,LF,hip,0,0\n1,LF,hip,1,1\n"),
            "line 4: joint toe of limb LF is not once in frame 1, as in the first frame");
}

TEST(TrackTable, WhatIsNoNumberIsNamed) {
  for (const std::string bad : {"nan", "inf", "1e300", "", "x", "1,"}) {
    const std::string message = refused(header + square(0) + "1,LF,0," + bad + ",2\n");
    EXPECT_EQ(message.find("line 6: '"), 0U) << message;
  }
  EXPECT_EQ(refused(header + "0,LF,0,1e10,2\n"), "line 2: '1e10' is no number within +-1e+09");
  EXPECT_EQ(refused(header + "0,LF,0,1\n"), "line 2: '0,LF,0,1' has 4 entries, the header has 5");
  EXPECT_EQ(refused(header + "0,,0,1,2\n"), "line 2: the limb has no name");
  EXPECT_EQ(refused(header + "zero,LF,0,1,2\n"), "line 2: 'zero' is no number within +-1e+09");
}

TEST(TrackTable, TimesMustIncrease) {
  const auto timed = [](const char* first, const char* second) {
    std::string text = "frame,t,limb,joint,x,y\n";
    for (const char* joint : {"hip", "toe"}) {
      text += std::string("0,") + first + ",LF," + joint + ",0,1\n4," + second + ",LF," + joint +
              ",1,2\n";
    }
    return text;
  };
  EXPECT_EQ(read_track_table(timed("0", "0.1"), {}).tracks.times[1], 0.1);
  EXPECT_EQ(refused(timed("0.5", "0.5")),
            "line 3: time 0.5 of frame 4 does not exceed 0.5, that of the frame before");
  EXPECT_EQ(refused("frame,t,limb,joint,x,y\n0,1,LF,hip,0,0\n0,2,LF,toe,0,0\n"),
            "line 3: time 2 of frame 0, which is 1 in line 2");
}

TEST(TrackTable, LimbsAreCounted) {
  std::string text = header;
  for (int i = 0; i < 101; ++i) text += "0,limb-" + std::to_string(i) + ",0,0,0\n";
  EXPECT_EQ(refused(text), "line 102: more than 100 limbs");
}

}  // namespace
}  // namespace wavecurve::io
