#include <string>

#include <gtest/gtest.h>

#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

class DistanceCommand : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    io::write_file(folder_ / "a.csv", "x,y\n0,0\n40,0\n40,30\n10,50\n");
    // Turned by 90 degrees, twice as large, elsewhere, from another point and the other way.
    io::write_file(folder_ / "b.csv", "y,x\n180,140\n180,200\n100,200\n120,100\n");
    io::write_file(folder_ / "c.csv", "0,0\n40,0\n40,40\n0,40\n");
    io::write_file(folder_ / "arc.csv", "x,y\n-0.5,0\n-0.3,0.4\n0,0.5\n0.3,0.4\n0.5,0\n");
  }

  double whole(const std::string& arguments) const {
    const ProgramRun run = wavecurve("distance " + arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const auto at = run.out.find("whole     ");
    EXPECT_NE(at, std::string::npos) << run.out;
    return std::stod(run.out.substr(at + 10));
  }
};

TEST_F(DistanceCommand, ComparesShapes) {
  EXPECT_EQ(whole("a.csv a.csv"), 0);
  EXPECT_GT(whole("a.csv c.csv"), 0.05);
  // A corner between two samples is cut off, by a quarter of their distance, 2 pi / 256, at most.
  EXPECT_LT(whole("a.csv b.csv"), 0.006);
  EXPECT_EQ(whole("arc.csv arc.csv --open"), 0);
  const ProgramRun run = wavecurve("distance a.csv c.csv --samples 64 --levels 2");
  EXPECT_NE(run.out.find("\n16        0."), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\n64        0."), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("elliptic Fourier descriptors, 20 harmonics: 0."), std::string::npos);
}

TEST_F(DistanceCommand, RefusesWhatCannotBeCompared) {
  expect_refusal("distance a.csv c.csv --filter bspline4.4", "orthonormal");
  expect_refusal("distance a.csv none.csv", "none.csv");
  io::write_file(folder_ / "line.svg",
                 "<svg><path d='M0 0L5 5 9 5' fill='none' stroke='red'/></svg>");
  expect_refusal("distance a.csv line.svg", "a.csv is closed, line.svg is open");
}

TEST_F(DistanceCommand, NormalizedDescriptorsOfEqualShapesAreEqual) {
  io::write_file(folder_ / "moved.csv", "x,y\n80,100\n0,100\n0,40\n60,0\n");
  const ProgramRun plain = wavecurve("describe a.csv --normalize");
  EXPECT_EQ(plain.exit_code, 0) << plain.err;
  EXPECT_EQ(wavecurve("describe moved.csv --normalize").out, plain.out);
  expect_refusal("describe a.csv --normalize --keep-corners", "excludes");
}

}  // namespace
}  // namespace wavecurve::tools
