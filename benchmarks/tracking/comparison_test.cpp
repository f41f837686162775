#include "benchmarks/tracking/comparison.hpp"

#include <gtest/gtest.h>

#include "benchmarks/tracking/compare.hpp"
#include "benchmarks/tracking/machine_fingerprint.hpp"

namespace wavecurve::tracking {
namespace {

Row row(const std::string& benchmark, const std::string& quantity, Change verdict) {
  return {benchmark, quantity, 100, 120, {1.2, 1.1, 1.3}, verdict, "noted"};
}

TEST(Comparison, ExitCodes) {
  Comparison c{"a", "b", {}, {}};
  EXPECT_EQ(c.exit_code(), 0);
  c.rows = {row("x", "time", Change::same), row("y", "time", Change::faster)};
  EXPECT_EQ(c.exit_code(), 0);
  c.rows.push_back(row("z", "time", Change::inconclusive));
  EXPECT_EQ(c.exit_code(), 4);
  c.rows.push_back(row("accuracy", "error", Change::slower));
  EXPECT_EQ(c.exit_code(), 1);
}

TEST(Comparison, CountsSettleWhatTimesLeaveOpen) {
  Comparison c{"a",
               "b",
               {row("x", "instructions", Change::same), row("x", "time", Change::inconclusive)},
               {}};
  EXPECT_EQ(c.verdict_of("x"), Change::same);
  c.rows[1].verdict = Change::slower;
  EXPECT_EQ(c.verdict_of("x"), Change::slower);
  c.rows[0].verdict = Change::faster;
  EXPECT_EQ(c.exit_code(), 1);
}

TEST(Comparison, Forms) {
  Comparison c{
      "old",
      "new",
      {row("x/1024", "time", Change::slower), row("unchanged", "instructions", Change::same)},
      {"a note"}};
  const std::string text = to_text(c, false);
  EXPECT_NE(text.find("note: a note"), std::string::npos);
  EXPECT_NE(text.find("1.100 .. 1.300"), std::string::npos);
  EXPECT_EQ(text.find("unchanged"), std::string::npos);
  EXPECT_NE(text.find("1 slower, 1 same: regression"), std::string::npos);
  EXPECT_NE(to_text(c, true).find("unchanged"), std::string::npos);
  EXPECT_NE(to_markdown(c).find("| x/1024 | time |"), std::string::npos);
  const Json json = to_json(c);
  EXPECT_EQ(json["exit_code"], 1);
  EXPECT_EQ(json["rows"][0]["verdict"], "slower");
  EXPECT_EQ(json["rows"][0]["lower"], 1.1);
}

/// A record as a build makes it, but small.
Json record() {
  return Json::parse(R"({"schema": 1, "date": "2026-01-01T00:00:00Z",
    "revision": {"commit": "0123456789"},
    "machine": {"cpu": "some", "kernel": "Linux 6"},
    "environment": {"compiler": "GNU 12.2.0", "flags": "-O3", "vectors": "AVX2",
                    "libraries": {"eigen": "3.4.0"}},
    "valgrind": {"version": "valgrind-3.19.0", "vectors": "AVX2"},
    "kernels": {"transform": {"size": 64, "instructions": 10000.0, "data_reads": 2000.0,
                              "data_writes": 1000.0}},
    "accuracy": {"round_trip": {"kind": "error", "value": 1e-16},
                 "proved": {"kind": "digits", "value": 50.0}},
    "benchmarks": [{"program": "p", "name": "transform/64", "time_unit": "us",
                    "cpu_time": [10.0, 10.1, 9.9, 10.0, 10.05]}]})");
}

Comparison compare_records(const Json& a, const Json& b, bool is_forced = false) {
  CompareOptions options;
  options.is_forced = is_forced;
  return compare({"a", {}, a}, {"b", {}, b}, options, [](const auto&) {});
}

TEST(CompareRecords, TheSameIsTheSame) {
  const Comparison c = compare_records(record(), record());
  EXPECT_EQ(c.exit_code(), 0);
  EXPECT_EQ(c.rows.size(), 4u);
  EXPECT_TRUE(c.notes.empty());
}

TEST(CompareRecords, FindsInstructionsAndLossOfAccuracy) {
  Json slow = record();
  slow["kernels"]["transform"]["instructions"] = 10100;
  EXPECT_EQ(compare_records(record(), slow).verdict_of("transform/64"), Change::slower);
  Json wrong = record();
  wrong["accuracy"]["round_trip"]["value"] = 2e-16;
  EXPECT_EQ(compare_records(record(), wrong).exit_code(), 1);
  Json fewer = record();
  fewer["accuracy"]["proved"]["value"] = 49;
  EXPECT_EQ(compare_records(record(), fewer).exit_code(), 1);
  Json broken = record();
  broken["accuracy"]["proved"]["value"] = nullptr;
  EXPECT_EQ(compare_records(record(), broken).exit_code(), 1);
}

TEST(CompareRecords, TimesThatWereNotMeasuredTogetherRaiseNoAlarm) {
  Json slow = record();
  slow["benchmarks"][0]["cpu_time"] = {20, 20.1, 19.9, 20, 20};
  slow.erase("kernels");
  Json before = record();
  before.erase("kernels");
  const Comparison c = compare_records(before, slow);
  EXPECT_EQ(c.verdict_of("transform/64"), Change::inconclusive);
  EXPECT_EQ(c.exit_code(), 4);
}

TEST(CompareRecords, OtherMachinesAreRefusedUnlessForced) {
  Json other = record();
  other["machine"]["cpu"] = "another";
  try {
    compare_records(record(), other);
    FAIL();
  } catch (const MachinesDiffer& error) {
    EXPECT_NE(std::string(error.what()).find("machine/cpu: some, now another"), std::string::npos);
  }
  const Comparison forced = compare_records(record(), other, true);
  EXPECT_EQ(forced.exit_code(), 0);
  EXPECT_EQ(forced.notes.size(), 1u);
  // The project's own choice of flags is what is compared, not the machine.
  Json flags = record();
  flags["environment"]["flags"] = "-O2";
  EXPECT_EQ(compare_records(record(), flags).notes.size(), 1u);
}

TEST(Differences, NameWhatDiffers) {
  EXPECT_TRUE(differences(record(), record()).empty());
  Json other = record();
  other["environment"]["libraries"]["flint"] = "3";
  const std::vector<std::string> expected{"environment/libraries/flint: missing, now 3"};
  EXPECT_EQ(differences(record(), other), expected);
}

TEST(MachineFingerprint, TellsSomething) {
  const Json machine = machine_fingerprint();
  for (const char* key : {"cpu", "processors", "caches", "kernel", "governor"}) {
    EXPECT_TRUE(machine.contains(key)) << key;
  }
  EXPECT_EQ(machine, machine_fingerprint());
}

}  // namespace
}  // namespace wavecurve::tracking
