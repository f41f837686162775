#include "wavecurve/io/tracks/detail/wide_table.hpp"

#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"
#include "wavecurve/io/tracks/detail/joint_name.hpp"

namespace wavecurve::io {
namespace {

using Warned = std::vector<std::string>;

const std::string deep_lab_cut =
    "scorer,net,net,net,net,net,net\n"
    "bodyparts,LF_hip,LF_hip,LF_hip,LF_toe,LF_toe,LF_toe\n"
    "coords,x,y,likelihood,x,y,likelihood\n";

std::string refused(const std::string& text, const std::vector<std::string>& limbs = {}) {
  return test::refusal([&] { read_track_table(text, limbs); });
}

/// Joint k of the limb at frame i.
Eigen::RowVector2d at(const TrackTable& table, std::size_t i, Eigen::Index k) {
  return table.tracks.limbs.at(0).outlines.at(i).row(k);
}

TEST(WideTable, ReadsDeepLabCutsTables) {
  const TrackTable table =
      read_track_table(deep_lab_cut + "0,1,2,0.9,3,4,0.9\n1,5,6,0.7,7,8,0.7\n", {});
  EXPECT_TRUE(table.joints);
  EXPECT_EQ(table.warnings, Warned{});
  EXPECT_EQ(table.tracks.times, Eigen::Vector2d(0, 1));
  EXPECT_EQ(table.tracks.limbs.at(0).limb, "LF");
  EXPECT_EQ(at(table, 0, 0), Eigen::RowVector2d(1, 2));
  EXPECT_EQ(at(table, 1, 1), Eigen::RowVector2d(7, 8));
}

TEST(WideTable, UnlikelyPointsAreInterpolatedAndToldOf) {
  const std::string rows =
      "0,0,0,0.9,8,8,0.1\n1,50,50,0.59,2,2,1\n2,4,8,0.6,3,3,1\n3,5,5,1,nan,,1\n";
  const TrackTable table = read_track_table(deep_lab_cut + rows, {});
  EXPECT_EQ(at(table, 1, 0), Eigen::RowVector2d(2, 4));
  EXPECT_EQ(at(table, 0, 1), Eigen::RowVector2d(2, 2));  // the nearest
  EXPECT_EQ(at(table, 3, 1), Eigen::RowVector2d(3, 3));
  EXPECT_EQ(table.warnings, (Warned{"'LF_hip': 1 of 4 points are missing, or of a likelihood below "
                                    "0.6; they are interpolated, at most 1 in a row",
                                    "'LF_toe': 2 of 4 points are missing, or of a likelihood below "
                                    "0.6; they are interpolated, at most 1 in a row"}));
  EXPECT_EQ(at(read_track_table(deep_lab_cut + rows, {}, 0.1), 1, 0), Eigen::RowVector2d(50, 50));
  EXPECT_EQ(refused(deep_lab_cut + "0,0,0,0.9,8,8,0.1\n1,5,5,0.5,2,2,1\n"),
            "'LF_hip': 1 of 2 points are missing, or of a likelihood below 0.6");
}

TEST(WideTable, ReadsSleapsTables) {
  const std::string header =
      "track,frame_idx,instance.score,LF_hip.x,LF_hip.y,LF_hip.score,LF_toe.x,LF_toe.y,LF_toe.score\n";
  const TrackTable table =
      read_track_table(header + ",0,0.9,1,2,0.1,3,4,1\n,1,0.9,,,,5,6,1\n,3,0.9,4,2,1,9,8,1\n", {});
  EXPECT_EQ(table.tracks.times, Eigen::Vector4d(0, 1, 2, 3));
  EXPECT_EQ(at(table, 1, 0), Eigen::RowVector2d(2, 2));
  EXPECT_EQ(at(table, 2, 1), Eigen::RowVector2d(7, 7));  // a frame without animal
  EXPECT_EQ(table.warnings.at(0), "1 frames of 4 are not in the table; they are interpolated");
  EXPECT_EQ(refused(header + "a,0,1,1,2,1,3,4,1\nb,0,1,1,2,1,3,4,1\n"),
            "line 3: the table holds several animals, 'a' and 'b'; one is read");
}

TEST(WideTable, ReadsColumnsCalledAfterJoints) {
  const TrackTable table = read_track_table(
      "frame;t;RH_toe_x (px);RH_toe_y (px);RH_hip_x (px);RH_hip_y (px);nose_x;nose_y\n"
      "0;0,0;1,5;2;3;4;9;9\n1;0,5;5;6;7;8;9;9\n",
      {});
  EXPECT_EQ(table.tracks.times, Eigen::Vector2d(0, 0.5));
  EXPECT_EQ(table.tracks.limbs.at(0).limb, "RH");
  EXPECT_EQ(at(table, 0, 0), Eigen::RowVector2d(3, 4));  // the hip comes before the toe
  EXPECT_EQ(at(table, 0, 1), Eigen::RowVector2d(1.5, 2));
  EXPECT_EQ(table.warnings, Warned{"not read, for no limb has two such joints: nose"});
}

TEST(WideTable, WhatIsMissingIsNamed) {
  EXPECT_EQ(
      refused("frame,LF_toe_x,LF_toe_y\n0,1,2\n1,3,4\n"),
      "no limb has two joints: joints are called LF_hip, LF_toe, ..., or front_left_paw, ...");
  EXPECT_EQ(refused("frame,LF_toe_x,LF_toe_y,LF_hip_x\n"), "line 1: 'LF_hip' has no column y");
  const std::string header = "frame,LF_hip_x,LF_hip_y,LF_toe_x,LF_toe_y\n";
  EXPECT_EQ(refused(header + "0,1,2,3\n"), "line 2: '0,1,2,3' has 4 entries, the header has 5");
  EXPECT_EQ(refused(header + "0,1,2,3,4\n"), "1 frame; at least 2 are needed");
  EXPECT_EQ(refused(header + "0,1,2,3,4\n0,1,2,3,4\n"),
            "line 3: frame 0 does not exceed 0, that of the line before");
  EXPECT_EQ(refused(header + "0,1,2,3,4\n1,1,2,3,4\n1e9,1,2,3,4\n"),
            "frames are missing: there are 3 from 0 to 1000000000, in steps of 1");
  EXPECT_EQ(refused(header + "0,1,2,x,4\n"), "line 2: 'x' is no number within +-1e+09");
  EXPECT_EQ(refused(header + "0,1,2,3,4\n1,1,2,3,4\n", {"RH"}), "unknown limb 'RH'; known: LF");
  EXPECT_EQ(refused("scorer,a,a\nbodyparts,b,b\nno,x,y\n0,1,1\n"),
            "line 4: a header of scorer without coords");
  EXPECT_EQ(refused("scorer,n,n\nindividuals,a,b\nbodyparts,LF_a,LF_b\ncoords,x,x\n"),
            "the table holds several animals, 'a' and 'b'; one is read");
}

TEST(JointName, NamesTheLimb) {
  for (const char* name : {"LF_toe", "toe_lf", "FL.paw", "front_left_paw", "left_front_paw",
                           "L_F_paw", "leftFrontPaw", "Left Foreleg toe"}) {
    EXPECT_EQ(limb_of_joint(name), "LF") << name;
  }
  EXPECT_EQ(limb_of_joint("back_right_knee"), "RH");
  EXPECT_EQ(limb_of_joint("tail_base"), "TAIL");
  EXPECT_EQ(limb_of_joint("left_ear"), "");
  EXPECT_EQ(limb_of_joint("nose"), "");
}

TEST(JointName, KnowsTheOrderFromTheBodyToTheToe) {
  const char* order[] = {"LF_scapula", "shoulder", "front_left_elbow", "carpus", "mcp",
                         "paw",        "toe"};
  for (int i = 1; i < 7; ++i) EXPECT_LT(*rank_of_joint(order[i - 1]), *rank_of_joint(order[i]));
  EXPECT_FALSE(rank_of_joint("LF_3"));
}

}  // namespace
}  // namespace wavecurve::io
