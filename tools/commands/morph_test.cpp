#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

/// Two drawings of two layers, in the folder.
class MorphCommand : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    io::write_file(folder_ / "a.svg",
                   R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">
                      <rect id="face" x="1" y="1" width="8" height="8" fill="#ffcc00"/>
                      <circle id="eye" cx="4" cy="4" r="1"/></svg>)");
    io::write_file(folder_ / "b.svg",
                   R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">
                      <circle id="face" cx="5" cy="5" r="4" fill="#00ccff"/>
                      <path id="eye" d="M5 3L7 5H3Z"/></svg>)");
  }

  bool is_there(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
};

TEST_F(MorphCommand, WritesByEnding) {
  for (const std::string name : {"out.svg", "out.json", "out.html"}) {
    const ProgramRun run = wavecurve("morph a.svg b.svg --samples 64 -o " + name);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out + run.err, "");
    EXPECT_TRUE(is_there(name));
  }
  const auto lottie = nlohmann::json::parse(io::read_file(folder_ / "out.json"));
  EXPECT_EQ(lottie["layers"].size(), 2u);
  ASSERT_EQ(wavecurve("morph a.svg b.svg --sheet --frames 6 -o sheet.svg").exit_code, 0);
  EXPECT_NE(io::read_file(folder_ / "sheet.svg").find("6 frames"), std::string::npos);
}

TEST_F(MorphCommand, RunsAreEqual) {
  const std::string arguments = "morph a.svg b.svg --crossings avoid --ease in-out --loop -o ";
  const ProgramRun first = wavecurve(arguments + "1.json"), again = wavecurve(arguments + "2.json");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.out, again.out);
  EXPECT_EQ(io::read_file(folder_ / "1.json"), io::read_file(folder_ / "2.json"));
}

TEST_F(MorphCommand, ReportsAndAvoidsCrossings) {
  const ProgramRun report = wavecurve("morph a.svg b.svg --crossings report -o out.json");
  ASSERT_EQ(report.exit_code, 0) << report.err;
  EXPECT_NE(report.out.find("face"), std::string::npos);
  EXPECT_NE(report.out.find("0 crossings in 58 frames"), std::string::npos) << report.out;
  const ProgramRun avoid =
      wavecurve("morph a.svg b.svg --crossings avoid --frames 11 --scale 256 -o out.json");
  ASSERT_EQ(avoid.exit_code, 0) << avoid.err;
  EXPECT_NE(avoid.out.find("256          0  as asked"), std::string::npos) << avoid.out;
}

TEST_F(MorphCommand, SaysWhatCannotBeAvoided) {
  // A figure of eight crosses itself in every frame; two bars pass over each other, and no hole.
  io::write_file(folder_ / "eight.svg",
                 R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">
                    <path d="M1 1L9 9V1L1 9Z"/></svg>)");
  const ProgramRun eight =
      wavecurve("morph eight.svg eight.svg --crossings avoid --frames 5 --samples 64 -o out.json");
  EXPECT_EQ(eight.exit_code, 1) << eight.err;
  EXPECT_NE(eight.out.find("path-1     64          3  as asked"), std::string::npos) << eight.out;
  EXPECT_NE(eight.out.find("no scale and start avoids all crossings"), std::string::npos);
  EXPECT_TRUE(is_there("out.json"));
  io::write_file(folder_ / "bars.svg",
                 R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">
                    <path d="M1 1H3V9H1zM7 1H9V9H7z"/></svg>)");
  io::write_file(folder_ / "beams.svg",
                 R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">
                    <path d="M1 1H9V3H1zM1 7H9V9H1z"/></svg>)");
  const ProgramRun bars =
      wavecurve("morph bars.svg beams.svg --crossings avoid --frames 5 -o out.json");
  EXPECT_EQ(bars.exit_code, 0) << bars.out;
  EXPECT_NE(bars.out.find("1024          0"), std::string::npos) << bars.out;
}

TEST_F(MorphCommand, TakesAMapAndAStart) {
  const auto bytes = [&](const std::string& options) {
    const ProgramRun run = wavecurve("morph a.svg b.svg --samples 64 " + options + " -o out.json");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return io::read_file(folder_ / "out.json");
  };
  const std::string plain = bytes("");
  EXPECT_NE(bytes("--map face=eye --map eye=face"), plain);
  EXPECT_EQ(bytes("--map face=face"), plain);
  EXPECT_NE(bytes("--start face=7"), plain);
  EXPECT_NE(bytes("--anchor face:0=2"), plain);
  EXPECT_EQ(bytes("--map face:0=face:0"), plain);
  EXPECT_NE(bytes("--detail stage --scale 8"), plain);
}

TEST_F(MorphCommand, MovesPhysically) {
  const auto bytes = [&](const std::string& options) {
    const ProgramRun run = wavecurve("morph a.svg b.svg --samples 64 " + options + " -o out.json");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out + run.err, "");
    return io::read_file(folder_ / "out.json");
  };
  const std::string plain = bytes("--motion physical");
  EXPECT_EQ(bytes("--motion physical"), plain);
  EXPECT_EQ(bytes("--motion physical --damping 0,0.1 --until settled --solver spectral"), plain);
  for (const std::string option :
       {"--stiffness 2", "--bending 0.01", "--density 3", "--damping 1,0.1", "--force 0,-3",
        "--until 1.5", "--solver decoupled", "--scale 8", "--frames 12", "--ease out", "--loop",
        "--density 0 --damping 0,0,9 --scale 8 --solver massless-crank-nicolson"}) {
    EXPECT_NE(bytes("--motion physical " + option), plain) << option;
  }
  EXPECT_EQ(bytes("--motion linear"), bytes(""));
  for (const std::string name : {"out.svg", "out.html"}) {
    EXPECT_EQ(wavecurve("morph a.svg b.svg --motion physical --samples 64 -o " + name).exit_code,
              0);
    EXPECT_TRUE(is_there(name));
  }
}

TEST_F(MorphCommand, GoesOnFromDrawingToDrawing) {
  io::write_file(folder_ / "c.svg",
                 R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 20">
                    <path id="face" d="M10 2L18 18H2Z" fill="#ccff00"/></svg>)");
  const auto lottie = [&](const std::string& options) {
    const ProgramRun run = wavecurve("morph a.svg b.svg c.svg --samples 64 -o out.json " + options);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return nlohmann::json::parse(io::read_file(folder_ / "out.json"));
  };
  const auto both = lottie("--duration 1,3 --fps 10");
  EXPECT_EQ(both["op"], 41);
  ASSERT_EQ(both["layers"].size(), 4U);
  // The upper layers are those of the second morph, which begins at frame 10.
  EXPECT_EQ(both["layers"][1]["nm"], "face-2");
  EXPECT_EQ(both["layers"][1]["ks"]["o"]["k"][1]["t"], 10);
  EXPECT_EQ(lottie("--loop --duration 1 --fps 10")["op"], 31);  // and back to the first
  EXPECT_EQ(lottie("--motion physical --frames 21")["op"], 21);
  for (const std::string output : {"out.svg", "out.html", "out.gif", "sheet.svg --sheet"}) {
    const ProgramRun run =
        wavecurve("morph a.svg b.svg c.svg --frames 7 --size 64x64 -o " + output);
    const bool takes_size = output.ends_with(".svg") || output.ends_with(".gif");
    EXPECT_EQ(run.exit_code, takes_size ? 0 : 2) << output << run.err;
  }
  EXPECT_EQ(wavecurve("morph a.svg b.svg c.svg -o out.html").exit_code, 0);
  EXPECT_EQ(wavecurve("morph a.svg b.svg c.svg --sheet -o sheet.svg").exit_code, 0);
  const std::string chain = "morph a.svg b.svg c.svg -o out.svg ";
  expect_refusal(chain + "--duration 1,2,3", "the number of durations is 3, but must be 1 or 2");
  expect_refusal(chain + "--duration 1,x", "'x' is not a number");
  expect_refusal("morph a.svg b.svg -o out.svg --duration 1,2",
                 "the number of durations is 2, but must be 1");
  expect_refusal(chain + "--map face=face", "--map takes two drawings, not 3");
  expect_refusal(chain + "--crossings report", "--crossings takes two drawings, not 3");
  expect_refusal("morph a.svg -o out.svg", "DRAWINGS");
}

TEST_F(MorphCommand, WritesThePathsOfBothEnds) {
  ASSERT_EQ(wavecurve("morph a.svg b.svg --paths -o out.json").exit_code, 0);
  const auto json = nlohmann::json::parse(io::read_file(folder_ / "out.json"));
  EXPECT_EQ(json["layers"][0]["id"], "face");
  EXPECT_EQ(json["layers"][0]["destination"]["fill"], "#00ccff");
  EXPECT_EQ(json["layers"][0]["source"]["d"].get<std::string>()[0], 'M');
  expect_refusal("morph a.svg b.svg --paths -o out.svg", "the file of --paths is 'out.svg'");
  expect_refusal("morph a.svg b.svg --paths --ease in -o out.json",
                 "--paths writes both ends alone");
}

TEST_F(MorphCommand, RefusesBadMotion) {
  const std::string morph = "morph a.svg b.svg --samples 64 -o out.json ";
  expect_refusal(morph + "--motion sideways", "sideways");
  expect_refusal(morph + "--stiffness 2", "--stiffness takes --motion physical");
  const std::string physical = morph + "--motion physical ";
  expect_refusal(physical + "--crossings report", "--crossings takes --motion linear");
  expect_refusal(physical + "--stiffness -1", "--stiffness: '-1' is not a number from 0");
  expect_refusal(physical + "--bending nan", "--bending: 'nan' is not");
  expect_refusal(physical + "--density -2", "--density: '-2' is not");
  expect_refusal(physical + "--density 0", "damping density above 0");
  expect_refusal(physical + "--damping 0,0", "damping is 0");
  expect_refusal(physical + "--damping 1", "--damping");
  expect_refusal(physical + "--force 1,inf", "--force: 'inf' is not");
  expect_refusal(physical + "--until never", "'never'");
  expect_refusal(physical + "--until 0", "until is 0");
  expect_refusal(physical + "--solver magic", "unknown solver 'magic'; known: spectral, decoupled");
  expect_refusal(physical + "--solver massless", "density is 1, but must be 0");
  expect_refusal(physical + "--scale 3", "scale is 3");
  EXPECT_FALSE(is_there("out.json"));
}

TEST_F(MorphCommand, RefusesBadInput) {
  io::write_file(folder_ / "empty.svg", "");
  expect_refusal("morph empty.svg b.svg -o out.json", "empty.svg");
  expect_refusal("morph a.svg missing.svg -o out.json", "missing.svg");
  expect_refusal("morph a.svg b.svg -o out.xyz", "none of .svg");
  expect_refusal("morph a.svg b.svg -o out.json --filter nope", "unknown filter 'nope'");
  expect_refusal("morph a.svg b.svg -o out.json --samples 100", "samples is 100");
  expect_refusal("morph a.svg b.svg -o out.json --samples 2", "samples is 2");
  expect_refusal("morph a.svg b.svg -o out.json --scale 7", "scale is 7");
  expect_refusal("morph a.svg b.svg -o out.json --scale fine",
                 "--scale is 'fine', but must be a number");
  expect_refusal("morph a.svg b.svg -o out.json --frames 1",
                 "--frames: '1' is not a whole number from 2");
  expect_refusal("morph a.svg b.svg -o out.json --duration 0",
                 "--duration: '0' is not a number from 0.001");
  expect_refusal("morph a.svg b.svg -o out.json --detail most", "--detail");
  expect_refusal("morph a.svg b.svg -o out.json --map face", "must be two layers, a=b, or");
  expect_refusal("morph a.svg b.svg -o out.json --map face=nose",
                 "unknown layer of the destination 'nose'; known: ");
  expect_refusal("morph a.svg b.svg -o out.json --start face=x", "'x'");
  expect_refusal("morph a.svg b.svg -o out.json --start face=5000", "5000");
  expect_refusal("morph a.svg b.svg -o out.json --anchor face:x=1", "must be a layer and vertices");
  expect_refusal("morph a.svg b.svg -o out.json --anchor face:-1=1",
                 "must be a layer and vertices");
  expect_refusal("morph a.svg b.svg -o out.json --anchor nose:0=1", "fits no layer of the source");
  expect_refusal("morph a.svg b.svg -o out.json --anchor face:77=1",
                 "vertices that are on no two matched contours");
  expect_refusal("morph a.svg b.svg -o out.json --map face:0=face:7",
                 "the contour of layer 'face' in a map is 7");
  expect_refusal("morph a.svg b.svg -o out.json --sheet",
                 "the file of a sheet is 'out.json', but must be");
  expect_refusal("morph a.svg b.svg", "--output");
  EXPECT_FALSE(is_there("out.json"));
  EXPECT_EQ(wavecurve("morph a.svg b.svg -o missing/out.json").exit_code, 3);
}

}  // namespace
}  // namespace wavecurve::tools
