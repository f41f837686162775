#include <string>

#include <nlohmann/json.hpp>

#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

class BenchCommand : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("before.json", record());
  }

  void write(const std::string& name, const nlohmann::json& json) const {
    io::write_file(folder_ / name, json.dump());
  }
  static nlohmann::json record() {
    return nlohmann::json::parse(R"({"schema": 1, "date": "2026-01-01T00:00:00Z",
      "revision": {"commit": "0123456789"}, "machine": {"cpu": "some"},
      "environment": {"compiler": "GNU 12.2.0", "flags": "-O3"},
      "kernels": {"transform": {"size": 64, "instructions": 10000, "data_reads": 2000,
                                "data_writes": 1000}},
      "accuracy": {"round_trip": {"kind": "error", "value": 1e-16}}})");
  }
};

TEST_F(BenchCommand, ExitCodesOfCompare) {
  EXPECT_EQ(wavecurve("bench compare before.json before.json").exit_code, 0);

  nlohmann::json slower = record();
  slower["kernels"]["transform"]["instructions"] = 10200;
  write("slower.json", slower);
  const ProgramRun regression =
      wavecurve("bench compare before.json slower.json --json c.json --markdown c.md");
  EXPECT_EQ(regression.exit_code, 1) << regression.err;
  EXPECT_NE(regression.out.find("1 slower, 1 same: regression"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(io::read_file(folder_ / "c.json"))["exit_code"], 1);
  EXPECT_NE(io::read_file(folder_ / "c.md").find("| transform/64 | instructions |"),
            std::string::npos);

  nlohmann::json elsewhere = record();
  elsewhere["machine"]["cpu"] = "another";
  write("elsewhere.json", elsewhere);
  const ProgramRun refused = wavecurve("bench compare before.json elsewhere.json");
  EXPECT_EQ(refused.exit_code, 5);
  EXPECT_NE(refused.err.find("some, now another"), std::string::npos);
  EXPECT_EQ(wavecurve("bench compare before.json elsewhere.json --force").exit_code, 0);

  for (auto* times : {&slower, &elsewhere}) {
    *times = record();
    times->erase("kernels");
    (*times)["benchmarks"] = {{{"program", "p"}, {"name", "x"}, {"time_unit", "ns"}}};
  }
  slower["benchmarks"][0]["cpu_time"] = {1, 1, 1};
  elsewhere["benchmarks"][0]["cpu_time"] = {2, 2, 2};
  write("fast.json", slower);
  write("slow.json", elsewhere);
  EXPECT_EQ(wavecurve("bench compare fast.json slow.json").exit_code, 4);
}

TEST_F(BenchCommand, RefusesWhatItCannotRead) {
  expect_refusal("bench compare before.json no-such-revision", "no-such-revision");
  io::write_file(folder_ / "no.json", "{}");
  expect_refusal("bench compare before.json no.json", "is no record");
  expect_refusal("bench self-test .", "no *_benchmark program");
  expect_refusal("bench compare before.json --blocks 3", "--blocks");
  expect_refusal("bench history --history nowhere -o .", "0 records");
}

TEST_F(BenchCommand, WritesTheHistoryAsAPage) {
  const ProgramRun run = wavecurve("bench history --history . -o page");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string html = io::read_file(folder_ / "page" / "history.html");
  EXPECT_NE(html.find("transform/64"), std::string::npos);
  EXPECT_NE(html.find("round_trip"), std::string::npos);
}

}  // namespace
}  // namespace wavecurve::tools
