#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

class GaitCommand : public ProgramTest {
 protected:
  static std::string example(const std::string& name) {
    return "'" WAVECURVE_SOURCE_DIR "/docs/examples/" + name + "'";
  }

  void write(const std::string& name, const std::string& text) const {
    io::write_file(folder_ / name, text);
  }

  void fit_example() const {
    const ProgramRun run =
        wavecurve("gait fit " + example("dog-walk.csv") + " --scale 16 -o walk.json");
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
};

TEST_F(GaitCommand, FitsShowsAndSynthesizes) {
  const ProgramRun fit =
      wavecurve("gait fit " + example("dog-walk.csv") + " --scale 16 -o walk.json");
  EXPECT_EQ(fit.exit_code, 0) << fit.err;
  EXPECT_NE(fit.out.find("LH    swing"), std::string::npos) << fit.out;
  const ProgramRun show = wavecurve("gait show walk.json");
  EXPECT_EQ(show.exit_code, 0) << show.err;
  EXPECT_NE(show.out.find("quadratic-by-level"), std::string::npos) << show.out;
  for (const char* output : {"walk.svg", "walk.html", "lottie.json", "walk.png"}) {
    const ProgramRun run =
        wavecurve("gait synthesize walk.json " + example("dog.svg") + " --frames 4 -o " + output);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("slide by at most 0.00 %"), std::string::npos) << run.out;
    EXPECT_TRUE(std::filesystem::exists(folder_ / output)) << output;
  }
  // A film of four frames, the one after the last is the first.
  EXPECT_TRUE(std::filesystem::exists(folder_ / "walk.png" / "frame-0004.png"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "walk.png" / "frame-0005.png"));
}

TEST_F(GaitCommand, HasGaitsAndOptions) {
  fit_example();
  const std::string dog = example("dog.svg");
  for (const char* options :
       {"--gait walk", "--gait gallop", "--subcycles", "--smooth", "--scale 4",
        "--cycles 3 --frames 30", "--period 0.5", "--sheet --frames 6", "--tolerance 0.1",
        "--fps 12", "--size 300x200 --background none"}) {
    const ProgramRun run =
        wavecurve("gait synthesize walk.json " + dog + " " + options + " -o out.svg");
    EXPECT_EQ(run.exit_code, 0) << options << ": " << run.err;
  }
}

TEST_F(GaitCommand, FilmsHaveTheRateAsked) {
  fit_example();
  const ProgramRun run = wavecurve("gait synthesize walk.json " + example("dog.svg") +
                                   " --period 0.52 --cycles 2 --fps 25 --size 90x60 -o walk.gif");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("0.52 seconds a cycle"), std::string::npos) << run.out;
  expect_refusal("gait synthesize walk.json " + example("dog.svg") + " --fps 9 --frames 9 -o o.svg",
                 "excludes");
}

TEST_F(GaitCommand, WritesTheSameBytesTwice) {
  fit_example();
  const std::string first = io::read_file(folder_ / "walk.json");
  fit_example();
  EXPECT_EQ(io::read_file(folder_ / "walk.json"), first);
  for (const char* output : {"a.json", "b.json"}) {
    wavecurve("gait synthesize walk.json " + example("dog.svg") + " -o " + output);
  }
  EXPECT_EQ(io::read_file(folder_ / "a.json"), io::read_file(folder_ / "b.json"));
}

/// A table of four square limbs in so many frames, of what a function makes of limb, frame and
/// point.
template <class Line>
std::string table(int frames, int points, Line line) {
  std::string text = "frame,limb,k,x,y\n";
  for (int frame = 0; frame < frames; ++frame) {
    for (const char* limb : {"LF", "RF", "LH", "RH"}) {
      for (int k = 0; k < points; ++k) text += line(std::string(limb), frame, k);
    }
  }
  return text;
}

std::string usual_line(const std::string& limb, int frame, int k) {
  // The foot, point 2, goes back on the ground and forth above it, in 8 frames.
  const int phase = (frame + (limb[0] == 'L' ? 0 : 4)) % 8;
  const double x[] = {4, 2, 0, -2, -4, -3, 0, 3}, y[] = {9, 9, 9, 9, 9, 7, 6, 7};
  const double px = k == 0 ? 0 : k == 2 ? x[phase] : k == 1 ? 1 : -1;
  const double py = k == 0 ? 0 : k == 2 ? y[phase] : 5;
  return std::to_string(frame) + ',' + limb + ',' + std::to_string(k) + ',' + std::to_string(px) +
         ',' + std::to_string(py) + '\n';
}

TEST_F(GaitCommand, RefusesBadTracks) {
  write("good.csv", table(24, 4, usual_line));
  const ProgramRun good = wavecurve("gait fit good.csv --scale full -o p.json");
  ASSERT_EQ(good.exit_code, 0) << good.err;

  const auto without = [](auto is_left_out) {
    return [is_left_out](const std::string& limb, int frame, int k) {
      return is_left_out(limb, frame) ? std::string() : usual_line(limb, frame, k);
    };
  };
  const auto refuse = [&](const std::string& text, const std::string& message) {
    write("bad.csv", text);
    expect_refusal("gait fit bad.csv --scale full -o p.json", message);
  };
  refuse(table(24, 4, without([](const std::string& limb, int) { return limb[1] == 'F'; })),
         "no track of limb LF or RF");
  refuse(
      table(24, 4, without([](const std::string& limb, int f) { return limb == "RF" && f == 9; })),
      "RF");  // vanishes for a frame
  refuse(
      table(24, 4, without([](const std::string& limb, int f) { return limb == "LH" && f < 5; })),
      "LH");  // appears
  refuse(table(1, 4, usual_line), "frame");
  refuse(table(24, 3, usual_line), "3");
  refuse(table(24, 4,
               [](const std::string& limb, int frame, int k) {
                 return frame == 7 && k == 1 ? std::string("7,").append(limb).append(",1,nan,2\n")
                                             : usual_line(limb, frame, k);
               }),
         "nan");
  refuse(table(24, 4, [](const std::string& limb, int, int k) { return usual_line(limb, 0, k); }),
         "");  // every frame has the same number
  refuse(table(24, 4,
               [](const std::string& limb, int frame, int k) {
                 // Standing still.
                 const std::string line = usual_line(limb, 0, k);
                 return std::to_string(frame) + line.substr(line.find(','));
               }),
         "the foot of limb 'LF' does not move");
  expect_refusal("gait fit missing.csv -o p.json", "missing.csv");
}

TEST_F(GaitCommand, RefusesBadKeyFramesScalesAndModels) {
  write("good.csv", table(24, 4, usual_line));
  const std::string fit = "gait fit good.csv --scale full -o p.json ";
  expect_refusal(fit + "--key-frames 5,90", "key frame 2 is at 90, but the record is from 0 to 23");
  expect_refusal(fit + "--key-frames 5,5", "key frame 2 is 0 after key frame 1");
  expect_refusal(fit + "--model straight", "unknown model 'straight'; known: linear, quadratic");
  expect_refusal("gait fit good.csv --scale 3 -o p.json", "scale is 3");
  expect_refusal("gait fit good.csv --scale few -o p.json",
                 "--scale is 'few', but must be a number");
  expect_refusal("gait fit good.csv", "--output");
  expect_refusal("gait", "subcommand");
}

TEST_F(GaitCommand, RefusesBadSyntheses) {
  fit_example();
  const std::string dog = example("dog.svg");
  expect_refusal("gait synthesize walk.json " + dog + " --gait tort -o out.svg",
                 "unknown gait 'tort'; known: walk");
  expect_refusal("gait synthesize walk.json " + example("face-dog.svg") + " -o out.svg",
                 "the drawing has no layer 'LF'");
  expect_refusal("gait synthesize walk.json " + dog + " --frames 1 -o out.svg",
                 "'1' is not a whole number from 2");
  expect_refusal("gait synthesize walk.json " + dog + " --cycles 0 -o out.svg",
                 "'0' is not a whole number from 1");
  expect_refusal("gait synthesize walk.json " + dog + " --scale 3 -o out.svg", "scale is 3");
  expect_refusal("gait synthesize walk.json " + dog + " --period 0 -o out.svg",
                 "'0' is not a number from 0.001");
  expect_refusal("gait synthesize walk.json " + dog + " --sheet -o out.html",
                 "the file of a sheet is 'out.html', but must be");
  expect_refusal("gait synthesize walk.json " + dog + " -o out.bmp", "out.bmp");
  write("other.json", "{}");
  expect_refusal("gait synthesize other.json " + dog + " -o out.svg", "wavecurve-gait");
  expect_refusal("gait show other.json", "wavecurve-gait");
  // Parameters of limbs that no drawing of a dog has.
  auto document = nlohmann::json::parse(io::read_file(folder_ / "walk.json"));
  for (auto& limb : document["limbs"]) limb["limb"] = "wing";
  write("wings.json", document.dump());
  expect_refusal("gait synthesize wings.json " + dog + " -o out.svg",
                 "neither limb LF nor limb RF");
}

}  // namespace
}  // namespace wavecurve::tools
