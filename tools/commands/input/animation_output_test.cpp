#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

class AnimationOutput : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    io::write_file(folder_ / "a.csv", "0,0\n4,0\n4,3\n1,5\n");
    io::write_file(folder_ / "b.csv", "0,0\n5,1\n4,4\n0,5\n");
  }
  std::string written(const std::string& name, const std::string& options) const {
    const ProgramRun run = wavecurve("morph a.csv b.csv --samples 64 -o " + name + " " + options);
    EXPECT_EQ(run.exit_code, 0) << options << run.err;
    return io::read_file(folder_ / name);
  }
  /// Width, height, rate and number of frames.
  std::string probed(const std::string& name) const {
    return run("ffprobe -v error -count_frames -show_entries "
               "stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 '" +
               (folder_ / name).string() + "'")
        .out;
  }
};

TEST_F(AnimationOutput, FilmsHaveTheSizeAndRateAsked) {
  written("o.webm", "--size 60x40 --fps 12.5 --duration 0.49");
  EXPECT_EQ(probed("o.webm"), "60,40,25/2,7\n");  // the duration is rounded to six steps
  written("o.gif", "--size 61x41 --fps 10 --duration 1 --background none");
  EXPECT_EQ(probed("o.gif"), "61,41,10/1,11\n");
}

TEST_F(AnimationOutput, PicturesHaveTheSizeAndBackgroundAsked) {
  const auto lottie = nlohmann::json::parse(written("o.json", "--size 61x41 --background tomato"));
  EXPECT_EQ(lottie["w"], 61);
  EXPECT_EQ(lottie["h"], 41);
  EXPECT_EQ(lottie["layers"].back()["sc"], "#ff6347");
  const std::string svg = written("o.svg", "--size 61x41 --background 'rgb(255 0 0)'");
  EXPECT_NE(svg.find("width=\"61\" height=\"41\""), std::string::npos);
  EXPECT_NE(svg.find("fill=\"#ff0000\""), std::string::npos);
  EXPECT_NE(written("o.html", "--background '#abc'").find("\"background\":\"#aabbcc\""),
            std::string::npos);
  EXPECT_EQ(written("s.svg", "--sheet --background none --frames 4").find("<rect"),
            std::string::npos);
}

TEST_F(AnimationOutput, HoldsCurvesToATenthOfAPixelByDefault) {
  const std::size_t polygons = written("o.svg", "--tolerance 0").size();
  EXPECT_LT(written("o.svg", "").size(), polygons * 0.6);
  EXPECT_LT(written("o.svg", "--size 32x32").size(), written("o.svg", "").size());
  EXPECT_LT(written("o.html", "").size(), written("o.html", "--tolerance 0").size());
}

TEST_F(AnimationOutput, RefusesWhatAFormatDoesNotHave) {
  const std::string morph = "morph a.csv b.csv -o ";
  for (const char* colour : {"''", "nope", "'rgba(0,0,0,.5)'", "'#12345'", "'url(x)'", "None"}) {
    expect_refusal(morph + "o.svg --background " + colour,
                   "is not an opaque colour of CSS, or none");
  }
  expect_refusal(morph + "o.mp4 --background none", "--background none is not for .mp4");
  expect_refusal(morph + "o.html --size 40x40", "--size is not for .html");
  expect_refusal(morph + "o.mp4 --size 41x40",
                 "the size of an .mp4 is '41x40', but must be two even");
  expect_refusal(morph + "o.gif --fps 200", "at most 100 frames a second");
  expect_refusal(morph + "o.gif --fps 1000 --duration 86400", "--fps 1000 makes 86400000 frames");
  expect_refusal(morph + "o.gif --fps 0.1 --duration 4",
                 "--fps 0.1 has no second frame in 4 seconds");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 4);
}

}  // namespace
}  // namespace wavecurve::tools
