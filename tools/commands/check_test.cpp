#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <sys/wait.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

struct Result {
  int exit_code = -1;
  std::string output, errors;
};

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class CheckCommand : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "wavecurve_checkXXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Result run(const std::string& arguments) const {
    const std::string command = std::string(WAVECURVE_PROGRAM) + " check " + arguments + " >" +
                                (folder_ / "out").string() + " 2>" + (folder_ / "err").string();
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), read(folder_ / "out"), read(folder_ / "err")};
  }

  Result check(const std::string& table, const std::string& options = "") const {
    std::ofstream(folder_ / "t.csv", std::ios::binary) << table;
    return run((folder_ / "t.csv").string() + " " + options);
  }

  const std::string published_ = std::string(WAVECURVE_SOURCE_DIR) + "/verification/published/";
  std::filesystem::path folder_;
};

TEST_F(CheckCommand, ExitsWithZeroIfEveryValueIsRight) {
  const Result result = run(published_ + "table_1.csv");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE(result.output.find("24 certified"), std::string::npos);
  EXPECT_TRUE(result.errors.empty());
}

TEST_F(CheckCommand, ExitsWithOneIfAValueIsNot) {
  const Result result = run(published_ + "table_2.csv");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.output.find("13 published-route"), std::string::npos);
  EXPECT_NE(result.output.find("eigenvalue nearest zero"), std::string::npos);
}

TEST_F(CheckCommand, PrintsJson) {
  const Result result = run(published_ + "table_2.csv --format json");
  const auto json = nlohmann::json::parse(result.output);
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
  const Result result = run(published_ + "table_1.csv --format csv");
  EXPECT_TRUE(
      result.output.starts_with("filter,quantity,index,printed,verdict,certified,ulps,detail\n"
                                "D8,alpha,0,2.000000000000,certified,2.000000000000,0,\n"));
}

TEST_F(CheckCommand, TwoRunsGiveTheSameBytes) {
  const std::string arguments = published_ + "table_2.csv --format json";
  EXPECT_EQ(run(arguments).output, run(arguments).output);
}

TEST_F(CheckCommand, RefusesBadTablesInOneLine) {
  const std::string header = "filter,quantity,index,printed\n";
  for (const std::string& table :
       {std::string(), header, std::string("filter,index,printed\nD8,0,1\n"), header + "D9,h,0,1\n",
        header + "D8,x,0,1\n", header + "D8,h,99,1\n", header + "D8,h,0,zero\n",
        header + std::string(1000000, '9') + "\n", std::string("\x89PNG\r\n\x1a\n\0\0\0", 11),
        header + "db2,mu,0,1\n"}) {
    const Result result = check(table);
    EXPECT_EQ(result.exit_code, 2) << result.errors;
    EXPECT_TRUE(result.output.empty());
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_NE(result.errors.find("t.csv:"), std::string::npos) << result.errors;
    EXPECT_LT(result.errors.size(), 600U);
  }
}

TEST_F(CheckCommand, RefusesBadUsage) {
  EXPECT_EQ(run("").exit_code, 2);
  EXPECT_EQ(run(published_ + "table_1.csv --format yaml").exit_code, 2);
  EXPECT_EQ(run("no/such/table.csv").exit_code, 2);
  EXPECT_EQ(run("/").exit_code, 2);
}

}  // namespace
