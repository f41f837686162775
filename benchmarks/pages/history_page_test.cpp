#include "benchmarks/pages/history_page.hpp"

#include <stdexcept>
#include <variant>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "benchmarks/pages/history_charts.hpp"

namespace wavecurve::tracking {
namespace {

/// Ten records, of which the last four have a kernel that takes twice the time and instructions.
std::vector<Json> history() {
  std::vector<Json> records;
  for (int i = 0; i < 10; ++i) {
    Json record = Json::parse(R"({"schema": 1, "accuracy": {"round": {"kind": "error"}},
      "limits": {"kernels": {"transform": {"copy_seconds": 1e-7}}}})");
    const double scale = i < 6 ? 1 : 2;
    record["date"] = fmt::format("2026-01-{:02}T00:00:00Z", i + 1);
    record["revision"] = {{"commit", fmt::format("{:08x}", i)}};
    record["accuracy"]["round"]["value"] = 1e-16;
    record["kernels"]["transform"] = {
        {"size", 64}, {"instructions", 1000 * scale}, {"data_reads", 300}, {"data_writes", 200}};
    record["benchmarks"] = {{{"program", "kernel_benchmark"},
                             {"name", "transform/64"},
                             {"time_unit", "us"},
                             {"cpu_time", {scale, 1.01 * scale}}}};
    records.push_back(record);
  }
  return records;
}

TEST(HistoryPage, MarksWhereAKernelChanged) {
  const reports::Page page = history_page(history());
  const auto& overview = std::get<verification::Table>(page.sections[0].evidence[1]);
  ASSERT_EQ(overview.rows.size(), 1u);
  const auto& row = overview.rows[0];
  EXPECT_EQ(row[0], "transform/64");
  EXPECT_EQ(row[2], "0.1");
  EXPECT_EQ(row[3], "copy");
  EXPECT_EQ(row[6], "00000006");
  EXPECT_EQ(row[7], "00000006");
  const auto& accuracy = std::get<verification::Table>(page.sections[1].evidence[1]);
  EXPECT_EQ(accuracy.rows[0].back(), "none");
  const auto& chart = std::get<verification::Chart>(page.sections[2].evidence[0]);
  EXPECT_NE(chart.script.find("set arrow from 6.5"), std::string::npos);
  EXPECT_EQ(chart.data.rows.size(), 10u);
}

TEST(HistoryPage, DrawsTheAccuraciesThatChanged) {
  std::vector<Json> records = history();
  for (std::size_t i = 0; i < records.size(); ++i) {
    records[i]["accuracy"]["steps"] = {{"kind", "iterations"}, {"value", i < 4 ? 10 : 15}};
  }
  const verification::Chart chart = accuracy_chart(records);
  const std::vector<std::string> columns{"record", "revision", "steps (iterations)",
                                         "1 quantities that never changed"};
  EXPECT_EQ(chart.data.columns, columns);
  EXPECT_EQ(chart.data.rows[3], (std::vector<std::string>{"4", "00000003", "1", "1"}));
  EXPECT_EQ(chart.data.rows[4], (std::vector<std::string>{"5", "00000004", "1.5", "1"}));
  EXPECT_NE(chart.script.find("set arrow from 4.5"), std::string::npos);
}

TEST(HistoryPage, ShowsWhyAKernelIsFarFromItsLimitAndWhetherThatIsOld) {
  const auto why = [](const std::string& measured) {
    const reports::Page page = history_page(history(), {measured, {{"transform", "branches"}}});
    return std::get<verification::Table>(page.sections[0].evidence[2]).rows.at(0).back();
  };
  EXPECT_EQ(why("00000009"), "branches");
  EXPECT_EQ(why("00000003"), "(Measured at revision 00000003, not at this record's.) branches");
}

TEST(HistoryPage, TakesRecordsThatLackParts) {
  std::vector<Json> records = history();
  for (const char* part : {"kernels", "benchmarks", "limits", "accuracy"}) {
    records[3].erase(part);
    EXPECT_NO_THROW(history_page(records)) << part;
  }
  EXPECT_NO_THROW(history_page({records[3]}));
  EXPECT_THROW(history_page({}), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::tracking
