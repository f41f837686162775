#include <string>

#include <nlohmann/json.hpp>

#include "wavecurve/io/write_file.hpp"

#include "program_test.hpp"

namespace wavecurve::tools {
namespace {

using CompareCommand = ProgramTest;

TEST_F(CompareCommand, WritesOnePointASolverAndTolerance) {
  const ProgramRun run = wavecurve("compare --solvers decoupled,coupled --format json -o study");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(io::read_file(folder_ / "study" / "compare.json"), run.out);
  const auto points = nlohmann::json::parse(run.out)["points"];
  ASSERT_GT(points.size(), 2u);
  const auto& first = points[0];
  EXPECT_EQ(first["solver"], "decoupled");
  EXPECT_EQ(first["filter"], "db4");
  EXPECT_EQ(first["samples"], 64);
  EXPECT_EQ(first["levels"], 6);
  EXPECT_EQ(first["shape"], "ellipse");
  EXPECT_EQ(first["damping"], nlohmann::json({0, 0}));
  EXPECT_TRUE(first["tolerance"].is_null());
  EXPECT_GT(first["error"]["displacement_l2_max"], 1.3);
  EXPECT_TRUE(first["error"].contains("displacement_l2_final"));
  EXPECT_TRUE(first["error"].contains("energy_norm_max"));
  EXPECT_TRUE(first["cost"].contains("evaluations"));
  EXPECT_GT(first["cost"]["seconds"], 0);
  EXPECT_EQ(first["status"], "ok");
  EXPECT_EQ(points[1]["solver"], "coupled");
  EXPECT_GT(points[1]["tolerance"], 0);
}

TEST_F(CompareCommand, KeepsFailedSolves) {
  const ProgramRun json = wavecurve("compare --solvers massless --format json");
  ASSERT_EQ(json.exit_code, 0) << json.err;
  const auto point = nlohmann::json::parse(json.out)["points"][0];
  EXPECT_EQ(point["status"], "failed");
  EXPECT_TRUE(point["error"].is_null());
  const ProgramRun csv = wavecurve("compare --solvers massless,spectral --format csv");
  EXPECT_NE(csv.out.find(",failed\n"), std::string::npos);
  EXPECT_NE(csv.out.find(",ok\n"), std::string::npos);
  const ProgramRun text = wavecurve("compare --solvers massless");
  EXPECT_NE(text.out.find("failed: density is 1"), std::string::npos) << text.out;
}

TEST_F(CompareCommand, TakesADrawingDampingAndLevels) {
  io::write_file(folder_ / "disc.svg",
                 R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">
                    <ellipse cx="5" cy="5" rx="4" ry="3"/></svg>)");
  const std::string arguments = "compare --shape disc.svg --solvers decoupled --format json ";
  const auto error = [&](const std::string& more) -> double {
    const ProgramRun run = wavecurve(arguments + more);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return nlohmann::json::parse(run.out)["points"][0]["error"]["displacement_l2_max"];
  };
  EXPECT_GT(error(""), 0.5);
  EXPECT_LT(error("--damping 0,10"), 0.01);
  EXPECT_NE(error("--levels 2"), error(""));
}

TEST_F(CompareCommand, RefusesBadInput) {
  expect_refusal("compare --samples 63", "63");
  expect_refusal("compare --samples 64 --levels 7", "7");
  expect_refusal("compare --shape blob", "ellipse, star, dent");
  expect_refusal("compare --damping -1,0", "-1");
  expect_refusal("compare --damping 1", "--damping");
  expect_refusal("compare --solvers magic", "magic");
  expect_refusal("compare --filter nope", "unknown filter 'nope'");
  expect_refusal("compare --shape missing.svg", "missing.svg");
  io::write_file(folder_ / "file", "");
  EXPECT_EQ(wavecurve("compare --solvers spectral -o file").exit_code, 3);
}

}  // namespace
}  // namespace wavecurve::tools
