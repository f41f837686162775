#include <string>

#include <nlohmann/json.hpp>

#include "wavecurve/curves/descriptor.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/descriptor_json.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

using DescribeCommand = ProgramTest;

const std::string face = "'" WAVECURVE_SOURCE_DIR "/docs/examples/face-cat.svg'";
const std::string three = "'" WAVECURVE_SOURCE_DIR "/docs/examples/three.svg'";

/// Row 0 .. samples - 1 of each contour of a CSV file written by reconstruct.
Contour points_of(const std::filesystem::path& path, Eigen::Index samples) {
  const Layer layer = io::read_drawing(path).drawing.layers.at(0);
  Contour points(static_cast<Eigen::Index>(layer.subpaths.size()) * samples, 2);
  Eigen::Index row = 0;
  for (const Subpath& subpath : layer.subpaths) {
    for (const BezierSegment& segment : subpath.segments) {
      if (row < points.rows()) points.row(row++) = segment.control.col(0);
    }
  }
  return points;
}

TEST_F(DescribeCommand, PrintsATable) {
  const ProgramRun run = wavecurve("describe " + three);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("filter bspline4.4, 256 samples a contour, 4 levels\n"))
      << run.out;
  EXPECT_NE(run.out.find("three        0  closed"), std::string::npos) << run.out;
  EXPECT_EQ(run.err, "");
}

TEST_F(DescribeCommand, GivesTheSamplesBack) {
  for (const char* more : {"", " --filter D8", " --filter K2 --interpolate --levels 2"}) {
    ASSERT_EQ(wavecurve("describe " + three + more + " --samples 128 -o d.json").exit_code, 0);
    ASSERT_EQ(wavecurve("reconstruct d.json -o d.csv").exit_code, 0);
    const Drawing drawing =
        io::read_drawing(WAVECURVE_SOURCE_DIR "/docs/examples/three.svg").drawing;
    const Contour expected = sample_layer(drawing.layers.at(0), 128).at(0);
    const Contour found = points_of(folder_ / "d.csv", 128);
    ASSERT_EQ(found.rows(), 128);
    EXPECT_LE((found - expected).norm(), 1e-13 * expected.norm()) << more;
  }
}

TEST_F(DescribeCommand, KeepsLayersAndPaints) {
  ASSERT_EQ(wavecurve("describe " + face + " -o face.json").exit_code, 0);
  ASSERT_EQ(wavecurve("reconstruct face.json --scale 32 -o face.svg").exit_code, 0);
  const Drawing before =
      io::read_drawing(WAVECURVE_SOURCE_DIR "/docs/examples/face-cat.svg").drawing;
  const Drawing after = io::read_drawing(folder_ / "face.svg").drawing;
  ASSERT_EQ(after.layers.size(), before.layers.size());
  for (std::size_t i = 0; i < after.layers.size(); ++i) {
    EXPECT_EQ(after.layers[i].id, before.layers[i].id);
    EXPECT_EQ(after.layers[i].paint.fill.has_value(), before.layers[i].paint.fill.has_value());
    EXPECT_EQ(after.layers[i].subpaths.size(), before.layers[i].subpaths.size());
  }
}

TEST_F(DescribeCommand, WritesWhatTheLibraryDescribes) {
  ASSERT_EQ(
      wavecurve("describe " + face + " --samples 64 --levels 2 --keep-corners -o f.json").exit_code,
      0);
  const Drawing drawing =
      io::read_drawing(WAVECURVE_SOURCE_DIR "/docs/examples/face-cat.svg").drawing;
  const Descriptor expected = describe(drawing, find_filter_bank("bspline4.4"),
                                       {64, 2, SampleMode::samples, Corners::kept});
  EXPECT_EQ(io::read_file(folder_ / "f.json"), io::descriptor_json(expected));
}

TEST_F(DescribeCommand, TakesPointsAndAUsersFilter) {
  io::write_file(folder_ / "p.csv", "0,0\n4,0\n4,3\n0,3\n");
  io::write_file(folder_ / "own.json", wavecurve("filter sym4 --format json").out);
  ASSERT_EQ(wavecurve("describe p.csv --samples 16 --filter own.json -o d.json").exit_code, 0);
  ASSERT_EQ(wavecurve("reconstruct d.json -o d.csv").exit_code, 0);
  const Contour found = points_of(folder_ / "d.csv", 16);
  EXPECT_LE((found.row(4) - Eigen::RowVector2d(3.5, 0)).norm(), 1e-12);
}

TEST_F(DescribeCommand, TellsWarningsOnTheErrorStream) {
  io::write_file(folder_ / "t.svg",
                 "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><text>3</text>"
                 "<rect width='4' height='3'/></svg>");
  const ProgramRun run = wavecurve("describe t.svg --samples 16 -o d.json");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(run.err.starts_with("wavecurve: t.svg: ")) << run.err;
  EXPECT_NE(run.err.find("text"), std::string::npos) << run.err;
}

TEST_F(DescribeCommand, RefusesBadInput) {
  expect_refusal("describe missing.svg", "missing.svg");
  expect_refusal("describe " + three + " --samples 100", "samples is 100");
  expect_refusal("describe " + three + " --samples 2", "samples is 2");
  expect_refusal("describe " + three + " --samples 64 --levels 7", "7");
  expect_refusal("describe " + three + " --filter nope", "unknown filter 'nope'");
  expect_refusal("describe " + three + " --filter bspline3.3 --interpolate", "smallest modulus");
  io::write_file(folder_ / "point.csv", "1,2\n");
  expect_refusal("describe point.csv", "point.csv");
  io::write_file(folder_ / "same.csv", "1,2\n1,2\n1,2\n");
  expect_refusal("describe same.csv", "same.csv");
  EXPECT_EQ(wavecurve("describe " + three + " -o missing/d.json").exit_code, 3);
  ASSERT_EQ(wavecurve("describe " + three + " -o d.json").exit_code, 0);
  expect_refusal("reconstruct d.json -o d.png", "but must be a file ending in .svg or .csv");
  expect_refusal("reconstruct d.json --scale 8 -o d.svg", "scale is 8");
  expect_refusal("reconstruct d.json --scale 24 -o d.svg", "scale is 24");
  expect_refusal("reconstruct d.json --scale many -o d.svg",
                 "--scale is 'many', but must be a number");
  expect_refusal("reconstruct point.csv -o d.svg", "point.csv: not JSON: line 1, column 2");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d.svg"));
}

}  // namespace
}  // namespace wavecurve::tools
