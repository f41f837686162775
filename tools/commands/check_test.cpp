#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

class CheckCommand : public ProgramTest {
 protected:
  // In quotes for the shell: the folder of the sources may have a blank in its path.
  const std::string table_1_ = "'" WAVECURVE_SOURCE_DIR "/verification/published/table_1.csv'";
  const std::string table_2_ = "'" WAVECURVE_SOURCE_DIR "/verification/published/table_2.csv'";
};

TEST_F(CheckCommand, ExitsWithZeroIfEveryValueIsRight) {
  const ProgramRun result = wavecurve("check " + table_1_);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("24 certified"), std::string::npos);
  EXPECT_TRUE(result.err.empty());
}

TEST_F(CheckCommand, ExitsWithOneIfAValueIsNot) {
  const ProgramRun result = wavecurve("check " + table_2_);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("13 published-route"), std::string::npos);
  EXPECT_NE(result.out.find("eigenvalue nearest zero"), std::string::npos);
}

TEST_F(CheckCommand, PrintsJson) {
  const ProgramRun result = wavecurve("check " + table_2_ + " --format json");
  const auto json = nlohmann::json::parse(result.out);
  ASSERT_EQ(json["rows"].size(), 36U);
  const auto& row = json["rows"][31];  // nu_7
  EXPECT_EQ(row["filter"], "K2");
  EXPECT_EQ(row["quantity"], "nu/nu0");
  EXPECT_EQ(row["index"], 7);
  EXPECT_EQ(row["printed"], "-0.00000270434");
  EXPECT_EQ(row["verdict"], "misprint");
  EXPECT_EQ(row["certified"], "-0.000000270434");
  EXPECT_NEAR(row["ulps"].get<double>(), 243391, 1);
  EXPECT_NE(row["detail"].get<std::string>().find("-0.000000270434"), std::string::npos);
  EXPECT_EQ(
      json["counts"],
      (nlohmann::json{{"certified", 16}, {"form", 2}, {"misprint", 5}, {"published-route", 13}}));
  EXPECT_EQ(json["columns"].size(), 3U);
  EXPECT_EQ(json["columns"][1]["matched"], 12);
}

TEST_F(CheckCommand, PrintsCsv) {
  const ProgramRun result = wavecurve("check " + table_1_ + " --format csv");
  EXPECT_TRUE(
      result.out.starts_with("filter,quantity,index,printed,verdict,certified,ulps,detail,route\n"
                             "D8,alpha,0,2.000000000000,certified,2.000000000000,0,,\n"));
}

TEST_F(CheckCommand, ShowsExtraColumnsInEveryFormat) {
  io::write_file(folder_ / "t.csv",
                 "# filter: D8\n# quantity: mu\nIndex;Value;page;verdict\n"
                 "0;342643/82248;12;\"a, b\"\n1;-2,6;13;\n");
  EXPECT_NE(wavecurve("check t.csv").out.find("a, b"), std::string::npos);
  const auto rows = nlohmann::json::parse(wavecurve("check t.csv --format json").out)["rows"];
  EXPECT_EQ(rows[0]["extra"], (nlohmann::json{{"page", "12"}, {"verdict", "a, b"}}));
  EXPECT_TRUE(rows[0]["ulps"].is_null()) << "a fraction has no last digit";
  EXPECT_EQ(rows[0]["certified"], "342643/82248");
  EXPECT_EQ(rows[1]["printed"], "-2,6");
  EXPECT_EQ(rows[1]["verdict"], "certified");
  const std::string csv = wavecurve("check t.csv --format csv").out;
  EXPECT_TRUE(csv.starts_with(
      "filter,quantity,index,printed,verdict,certified,ulps,detail,route,page,verdict (2)\n"))
      << csv;
  EXPECT_NE(csv.find(",exactly this fraction,,12,\"a, b\"\n"), std::string::npos) << csv;
}

TEST_F(CheckCommand, ReadsItsOwnTable) {
  io::write_file(folder_ / "own.csv", wavecurve("check " + table_1_ + " --format csv").out);
  EXPECT_EQ(wavecurve("check own.csv").exit_code, 0);
}

TEST_F(CheckCommand, RefusesWhatHasNoEndOrNoBound) {
  if (std::filesystem::exists("/dev/zero"))
    expect_refusal("check /dev/zero", "larger than 67108864");
  io::write_file(folder_ / "t.csv", "filter,quantity,index,printed\nD8,mu,-2147483648,1\n");
  expect_refusal("check t.csv", "t.csv:2: the index '-2147483648' is out of range");
}

TEST_F(CheckCommand, TwoRunsGiveTheSameBytes) {
  const std::string arguments = "check " + table_2_ + " --format json";
  EXPECT_EQ(wavecurve(arguments).out, wavecurve(arguments).out);
}

TEST_F(CheckCommand, RefusesBadTablesInOneLine) {
  const std::string header = "filter,quantity,index,printed\n";
  for (const std::string& table :
       {std::string(), header, std::string("filter,index,printed\nD8,0,1\n"), header + "D9,h,0,1\n",
        header + "D8,x,0,1\n", header + "D8,h,99,1\n", header + "D8,h,0,zero\n",
        header + std::string(1000000, '9') + "\n", std::string("\x89PNG\r\n\x1a\n\0\0\0", 11),
        header + "db2,mu,0,1\n"}) {
    io::write_file(folder_ / "t.csv", table);
    expect_refusal("check t.csv", "t.csv:");
    EXPECT_LT(wavecurve("check t.csv").err.size(), 600U);
  }
}

TEST_F(CheckCommand, RefusesBadUsage) {
  expect_refusal("check", "table");
  expect_refusal("check " + table_1_ + " --format yaml", "yaml");
  expect_refusal("check no/such/table.csv", "no/such/table.csv");
  expect_refusal("check /", "/");
}

}  // namespace
}  // namespace wavecurve::tools
