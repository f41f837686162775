#include "wavecurve/io/tracks/read_limb_tracks.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <zlib.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"
#include "wavecurve/io/files/detail/read_gzip.hpp"
#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/motion/gait/record/canine_joints.hpp"
#include "wavecurve/motion/gait/record/detail/skin_joints.hpp"
#include "wavecurve/motion/gait/record/detail/track_outlines.hpp"

namespace wavecurve::io {
namespace {

namespace fs = std::filesystem;
const fs::path shared = fs::path(WAVECURVE_SOURCE_DIR) / "../shared/data";
const fs::path walk = fs::path(WAVECURVE_SOURCE_DIR) / "docs/examples/dog-walk.csv";

class ReadLimbTracks : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    write_file(folder_ / name, text);
    return folder_ / name;
  }
  fs::path compress(const std::string& name, const std::string& text) const {
    gzFile file = gzopen((folder_ / name).c_str(), "wb");
    gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
    gzclose(file);
    return folder_ / name;
  }
  /// After the name of the file.
  std::string refused(const fs::path& path, const TrackOptions& options = {}) const {
    const std::string message = test::refusal([&] { read_limb_tracks({path}, options); });
    EXPECT_NE(message.find(path.string()), std::string::npos) << message;
    return message.substr(message.rfind(path.string()) + path.string().size() + 2);
  }

  fs::path folder_ = fs::temp_directory_path() / ("wavecurve-tracks-" + std::to_string(::getpid()));
};

/// The walk of the drawn dog as contours, `count` points each, in a table.
std::string contour_table(Eigen::Index count, double direction_of_y, bool reversed = false) {
  const gait::LimbTracks joints =
      gait::canine_joints(gait::drawn_dog(), gait::find_canine_gait("walk"),
                          Eigen::VectorXd::LinSpaced(24, 0, 23.0 / 16));
  std::string text = "frame,limb,k,x,y\n";
  for (const gait::LimbTrack& limb : joints.limbs) {
    const auto outlines = gait::skin_joints(limb.outlines, 8, 256);
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      for (Eigen::Index k = 0; k < count; ++k) {
        const Eigen::Index from = reversed ? (count - k) % count : k;
        const Eigen::RowVector2d point = outlines[i].row(from * 256 / count);
        text +=
            fmt::format("{},{},{},{},{}\n", i, limb.limb, k, point.x(), direction_of_y * point.y());
      }
    }
  }
  return text;
}

TEST_F(ReadLimbTracks, TheShippedWalkIsTheGeneratorsToItsThreeDecimals) {
  const gait::LimbTracks tracks = read_limb_tracks({walk});
  const Eigen::VectorXd phases = Eigen::VectorXd::LinSpaced(96, 0, 95.0 / 32);
  EXPECT_LT((tracks.times - 0.8 * phases).cwiseAbs().maxCoeff(), 1e-12);
  const gait::LimbTracks joints =
      gait::canine_joints(gait::drawn_dog(), gait::find_canine_gait("walk"), phases);
  ASSERT_EQ(tracks.limbs.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(tracks.limbs[i].limb, joints.limbs[i].limb);
    const auto& chains = joints.limbs[i].outlines;
    const auto expected = gait::skin_joints(chains, 0.06 * gait::chain_length(chains), 256);
    for (std::size_t t = 0; t < 96; ++t) {
      // Joints are off by half of the third decimal; where a limb is nearly straight, its outline
      // by a little more.
      const Contour difference = tracks.limbs[i].outlines.at(t) - expected[t];
      EXPECT_LT(difference.cwiseAbs().maxCoeff(), 5e-3) << i << ' ' << t;
    }
  }
}

TEST_F(ReadLimbTracks, OutlinesThatCorrespondStayAsTheyAre) {
  const gait::LimbTracks tracks = read_limb_tracks({write("a.csv", contour_table(128, 1))});
  const gait::LimbTracks joints =
      gait::canine_joints(gait::drawn_dog(), gait::find_canine_gait("walk"),
                          Eigen::VectorXd::LinSpaced(24, 0, 23.0 / 16));
  const auto outlines = gait::skin_joints(joints.limbs[0].outlines, 8, 256);
  ASSERT_EQ(tracks.limbs.at(0).outlines.at(5).rows(), 128);
  for (Eigen::Index k = 0; k < 128; ++k) {
    EXPECT_LT((tracks.limbs[0].outlines[5].row(k) - outlines[5].row(2 * k)).norm(), 1e-12);
  }
}

TEST_F(ReadLimbTracks, OutlinesBecomeClockwiseFromTheSamePoint) {
  const gait::LimbTracks plain = read_limb_tracks({write("a.csv", contour_table(128, 1))});
  const gait::LimbTracks reversed = read_limb_tracks({write("b.csv", contour_table(128, 1, true))});
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_GT(signed_area(reversed.limbs[i].outlines[7]), 0);
    EXPECT_EQ(reversed.limbs[i].outlines[7], plain.limbs[i].outlines[7]);
  }
}

TEST_F(ReadLimbTracks, UpIsFoundAndTurnedDown) {
  const gait::LimbTracks down = read_limb_tracks({write("down.csv", contour_table(64, 1))});
  const gait::LimbTracks up = read_limb_tracks({write("up.csv", contour_table(64, -1))});
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(up.limbs[i].outlines[7], down.limbs[i].outlines[7]);
    EXPECT_GT(signed_area(up.limbs[i].outlines[7]), 0);
  }
  TrackOptions options;
  options.y_axis = YAxis::up;
  const gait::LimbTracks turned = read_limb_tracks({folder_ / "down.csv"}, options);
  EXPECT_LT(turned.limbs[0].outlines[7].col(1).maxCoeff(), 0);
  options.y_axis = YAxis::down;
  EXPECT_LT(read_limb_tracks({folder_ / "up.csv"}, options).limbs[0].outlines[7](0, 1), 0);
}

TEST_F(ReadLimbTracks, NumbersOfPointsThatAreNoPowersOfTwoAreSampledAnew) {
  const gait::LimbTracks tracks = read_limb_tracks({write("a.csv", contour_table(100, 1))});
  EXPECT_EQ(tracks.limbs[0].outlines[0].rows(), 256);
  EXPECT_TRUE(gait::correspond(tracks.limbs[0].outlines));
  TrackOptions options;
  options.samples = 64;
  EXPECT_EQ(read_limb_tracks({folder_ / "a.csv"}, options).limbs[0].outlines[0].rows(), 64);
  options.samples = 100;
  EXPECT_THROW(read_limb_tracks({folder_ / "a.csv"}, options), std::invalid_argument);
}

TEST_F(ReadLimbTracks, TablesMayBePacked) {
  const std::string text = read_file(walk);
  const gait::LimbTracks plain = read_limb_tracks({walk});
  const gait::LimbTracks packed = read_limb_tracks({compress("walk.csv.gz", text)});
  EXPECT_EQ(packed.limbs[3].outlines[50], plain.limbs[3].outlines[50]);
  const std::string bytes = read_file(folder_ / "walk.csv.gz");
  EXPECT_EQ(refused(write("cut.csv.gz", bytes.substr(0, bytes.size() / 2))), "it ends too early");
  std::string changed = bytes;
  changed[bytes.size() / 2] = static_cast<char>(changed[bytes.size() / 2] ^ 0x55);
  EXPECT_EQ(refused(write("changed.csv.gz", changed)), "its gzip data are damaged");
}

TEST_F(ReadLimbTracks, UnpackingStopsAtTheBound) {
  const fs::path path = compress("zeros.gz", std::string(5'000'000, '0'));
  EXPECT_LT(fs::file_size(path), 100'000U);
  EXPECT_EQ(read_gzip(path, 1000).size(), 1001U);
  EXPECT_EQ(read_gzip(path, 5'000'000).size(), 5'000'000U);
  EXPECT_THROW(read_gzip(folder_ / "none.gz", 10), std::invalid_argument);
  EXPECT_THROW(read_gzip(folder_, 10), std::invalid_argument);
}

TEST_F(ReadLimbTracks, AFolderOfDrawingsIsATrack) {
  const auto frame = [](int i, const std::string& more) {
    return fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>"
        "<path id='LF' d='M{0} 10h8v50h-10z'/><path id='RF' d='M60 10h8v50h-10z'/>{1}</svg>",
        20 + i, more);
  };
  for (const int i : {1, 2, 9, 10, 11}) write("frame-" + std::to_string(i) + ".svg", frame(i, ""));
  write("notes.txt", "not a frame");
  const gait::LimbTracks tracks = read_limb_tracks({folder_});
  EXPECT_EQ(tracks.times, (Eigen::VectorXd(5) << 0, 1, 2, 3, 4).finished());
  ASSERT_EQ(tracks.limbs.size(), 2U);
  EXPECT_EQ(tracks.limbs[1].limb, "RF");
  // LF moves to the right with the number of the file; its first corner is tracked.
  const std::vector<double> moved{0, 1, 8, 9, 10};
  for (std::size_t i = 0; i < 5; ++i) {
    const Contour& outline = tracks.limbs[0].outlines.at(i);
    EXPECT_EQ(outline.rows(), 256);
    // Sampled twice: a corner is cut by at most a part of the distance of the finer points, 0.12.
    EXPECT_LT(((outline - tracks.limbs[0].outlines[0]).col(0).array() - moved[i]).abs().maxCoeff(),
              0.2);
  }
  write("frame-12.svg", frame(12, "<circle id='LH' r='5'/>"));
  EXPECT_EQ(test::refusal([&] { read_limb_tracks({folder_}); }),
            (folder_ / "frame-12.svg").string() + ": layer LH is not in the first frame");
  EXPECT_EQ(read_limb_tracks({folder_}, {.limbs = {"RF"}}).limbs.size(), 1U);
  EXPECT_EQ(test::refusal([&] { read_limb_tracks({folder_}, {.limbs = {"LH"}}); }),
            (folder_ / "frame-1.svg").string() + ": layer LH is missing; it must be in all frames");
  EXPECT_EQ(refused(folder_ / "frame-1.svg"), "1 SVG frame; at least 2 are needed");
}

TEST_F(ReadLimbTracks, ErrorsNameTheFile) {
  EXPECT_THROW(read_limb_tracks({}), std::invalid_argument);
  EXPECT_EQ(refused(folder_ / "none.csv"), "there is no such file or folder");
  EXPECT_EQ(refused(write("a.csv", "")), "the file is empty");
  EXPECT_EQ(refused(write("a.csv", "frame,limb,joint,x,y\n0,LF,hip,0,0\n")),
            "1 frame of the limbs to be read; at least 2 are needed");
  EXPECT_EQ(refused(folder_), "0 SVG frames; at least 2 are needed");
  EXPECT_THROW(read_limb_tracks({walk, walk}), std::invalid_argument);
  const std::string still = "0,LF,0,1,1\n0,LF,1,1,1\n0,LF,2,1,1\n0,LF,3,1,1\n";
  std::string later = still;
  for (std::size_t i = 0; i < later.size(); i += 11) later[i] = '1';
  EXPECT_EQ(refused(write("a.csv", "frame,limb,k,x,y\n" + still + later), {.samples = 64}),
            "limb LF: the length of a contour is 0, but must be above 0");
  EXPECT_EQ(refused(walk, {.thickness = 0}).find("limb LF: the radius of a limb is 0"), 0U);
}

class SharedTracks : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(shared)) GTEST_SKIP() << "no " << shared;
  }
  static gait::LimbTracks read(const std::string& name, const TrackOptions& options = {}) {
    return read_limb_tracks({shared / name}, options);
  }
  static double size(const gait::LimbTrack& track) {
    const Contour& first = track.outlines[0];
    return (first.colwise().maxCoeff() - first.colwise().minCoeff()).norm();
  }
};

/// The toes are below: what is lowest of a limb moves to and fro more than what is highest.
void expect_feet_below(const gait::LimbTracks& tracks) {
  for (const gait::LimbTrack& track : tracks.limbs) {
    if (track.limb.size() != 2) continue;
    Eigen::VectorXd foot(tracks.times.size()), top(tracks.times.size());
    for (Eigen::Index i = 0; i < foot.size(); ++i) {
      const Contour& outline = track.outlines[static_cast<std::size_t>(i)];
      Eigen::Index row = 0;
      outline.col(1).maxCoeff(&row);
      foot[i] = outline(row, 0);
      outline.col(1).minCoeff(&row);
      top[i] = outline(row, 0);
    }
    EXPECT_GT(foot.maxCoeff() - foot.minCoeff(), 1.5 * (top.maxCoeff() - top.minCoeff()))
        << track.limb;
  }
}

TEST_F(SharedTracks, TheTrotIsRead) {
  const gait::LimbTracks joints = read("gait/dog_trot_joints.csv");
  EXPECT_EQ(joints.times.size(), 111);
  EXPECT_EQ(joints.limbs.size(), 6U);
  EXPECT_NEAR(joints.times[110] - joints.times[0], 110.0 / 60, 1e-4);
  expect_feet_below(joints);
  const gait::LimbTracks contours = read("gait/dog_trot_limb_contours.csv.gz");
  EXPECT_EQ(contours.times.size(), 111);
  ASSERT_EQ(contours.limbs.size(), 4U);
  expect_feet_below(contours);
  for (const gait::LimbTrack& track : contours.limbs) {
    EXPECT_EQ(track.outlines.at(110).rows(), 128);  // as it is in the file
  }
  EXPECT_EQ(contours.limbs[0].outlines[0].row(0), Eigen::RowVector2d(0.44874, -0.30300));
}

TEST_F(SharedTracks, TheGallopIsReadInTheFrameOfTheBody) {
  const gait::LimbTracks tracks = read("gait/dog_gallop_joints.csv");
  EXPECT_EQ(tracks.times.size(), 201);
  EXPECT_EQ(tracks.limbs.size(), 6U);
  expect_feet_below(tracks);
}

TEST_F(SharedTracks, TheFoxIsReadAndItsStartsAreTracked) {
  const gait::LimbTracks joints = read("gait/fox_walk_joints.csv");
  EXPECT_EQ(joints.limbs.size(), 7U);
  expect_feet_below(joints);
  const gait::LimbTracks contours = read("gait/fox_walk_limb_contours.csv.gz");
  EXPECT_EQ(contours.times.size(), 48);
  ASSERT_EQ(contours.limbs.size(), 7U);
  expect_feet_below(contours);
  for (const gait::LimbTrack& track : contours.limbs) {
    EXPECT_TRUE(gait::correspond(track.outlines)) << track.limb;
    for (std::size_t i = 1; i < 48; ++i) {
      // In the file, starts jump by up to 98 of 256 points.
      const double step = (track.outlines[i] - track.outlines[i - 1]).rowwise().norm().maxCoeff();
      EXPECT_LT(step, 0.15 * size(track)) << track.limb << ' ' << i;
    }
  }
}

TEST_F(SharedTracks, TheHorsesOutlineIsReadAndHolesThatComeAndGoAreRefused) {
  const gait::LimbTracks tracks = read("animal_frames/muybridge_horse.csv", {.limbs = {"0"}});
  EXPECT_EQ(tracks.times.size(), 13);
  ASSERT_EQ(tracks.limbs.size(), 1U);
  EXPECT_EQ(tracks.limbs[0].outlines.at(12).rows(), 1024);
  EXPECT_TRUE(gait::correspond(tracks.limbs[0].outlines));
  EXPECT_NE(test::refusal([] {
              read("animal_frames/muybridge_horse.csv");
            }).find("limb 1 is not in frame"),
            std::string::npos);
}

}  // namespace
}  // namespace wavecurve::io
