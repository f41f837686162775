#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

class NumberOption : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    io::write_file(folder_ / "a.csv", "0,0\n4,0\n4,3\n1,5\n");
    io::write_file(folder_ / "b.csv", "0,0\n5,1\n4,4\n0,5\n");
  }
};

TEST_F(NumberOption, WhatIsNoNumberOfItsRangeIsRefusedWithTheRange) {
  const std::string morph = "morph a.csv b.csv -o o.svg ";
  for (const char* value : {"nan", "-nan", "inf", "-1", "''", "' '", "0x10", "1e400", "1,5", "1_0",
                            "'1 '", "++1", "1e", "2e9"}) {
    expect_refusal(morph + "--tolerance " + value,
                   "is not a number from 0 to 1e+09 (units of the drawing)");
  }
  for (const char* value : {"''", "nan", "2.5", "1", "2147483648", "9223372036854775808", "-5"}) {
    expect_refusal(morph + "--frames " + value, "is not a whole number from 2 to 100000");
  }
  expect_refusal(morph + "--duration 1e-320", "'1e-320' is not a number from 0.001 to 86400");
  expect_refusal(morph + "--motion physical --force nan,0", "--force: 'nan' is not a number");
  expect_refusal(morph + "--motion physical --damping 0,inf", "--damping: 'inf' is not a number");
  expect_refusal(morph + "--motion physical --until nan", "a number of units of time, or settled");
  expect_refusal(morph + "--scale 1e3", "a number of control points, or full");
  expect_refusal("gait fit x.csv -o o.json --thickness 9223372036854775807",
                 "is not a number above 0, at most 10 (times the length of the limb)");
  expect_refusal("bench compare a b --threshold nan", "'nan' is not a number from 0 to 1");
  expect_refusal("coefficients db4 --digits ''", "'' is not a whole number from 1 to 1000");
  for (const char* value : {"''", "400", "400x", "x400", "0x10", "1x9", "400x300x2", "4e2x300",
                            "16385x2", "16384x16384", "400x-3", "400*300"}) {
    expect_refusal(morph + "--size " + value,
                   "is not a size WIDTHxHEIGHT of numbers from 2 to 16384");
  }
  for (const char* value : {"nan", "0", "1001", "1e-320", "'30 '"}) {
    expect_refusal(morph + "--fps " + value, "is not a number from 0.01 to 1000");
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "o.svg"));
}

TEST_F(NumberOption, NumbersWithinTheirRangesAreTaken) {
  for (const char* value : {"0", "+0.5", "5e-1", ".5", "1e9", "-0"}) {
    const ProgramRun run =
        wavecurve("morph a.csv b.csv -o o.svg --frames +3 --tolerance " + std::string(value));
    EXPECT_EQ(run.exit_code, 0) << value << run.err;
  }
}

TEST_F(NumberOption, AnOptionThatAnotherMakesMeaninglessIsRefused) {
  const std::string morph = "morph a.csv b.csv -o o.svg ";
  expect_refusal(morph + "--sheet --loop", "excludes");
  expect_refusal(morph + "--sheet --duration 2", "excludes");
  expect_refusal(morph + "--sheet --size 40x40", "excludes");
  expect_refusal(morph + "--frames 9 --fps 3", "excludes");
  expect_refusal("morph a.csv b.csv -o o.json --paths --frames 9", "excludes");
  expect_refusal("morph a.csv b.csv -o o.json --paths --loop", "excludes");
  expect_refusal("morph a.csv b.csv -o o.gif --tolerance 1",
                 "--tolerance is for formats that hold curves, such as .svg, not for .gif");
  expect_refusal("gait synthesize p.json d.svg -o o.svg --subcycles --gait trot", "excludes");
  expect_refusal("coefficients db4 --quantity h --derivatives 1,1", "excludes");
  expect_refusal("coefficients db4 --integral 'phi phi' --normalize first", "excludes");
  expect_refusal("coefficients db4 --level 3", "--level takes --quantity or --on 0,x");
  expect_refusal("filter --list db4", "excludes");
  expect_refusal("filter --list --format json", "excludes");
  expect_refusal("identify --table --format json a.csv", "excludes");
  expect_refusal("verify --list --bless", "excludes");
  expect_refusal("bench record --only-counts --filter x", "excludes");
}

}  // namespace
}  // namespace wavecurve::tools
