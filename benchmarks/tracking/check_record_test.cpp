#include "benchmarks/tracking/check_record.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/io/files/detail/altered_json_test.hpp"

#include "benchmarks/tracking/compare.hpp"

namespace wavecurve::tracking {
namespace {

namespace fs = std::filesystem;

/// The latest record of the project, with two of its benchmarks, kernels and accuracies.
Json real_record() {
  Json record =
      read_history(fs::path(WAVECURVE_SOURCE_DIR) / "benchmarks" / "history").records.back();
  for (const char* key : {"benchmarks", "kernels", "accuracy"}) {
    Json& list = record.at(key);
    while (list.size() > 2) list.erase(std::prev(list.end()));
  }
  record.erase("limits");
  return record;
}

class CheckRecordTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  /// What is said of a record that is refused; empty where it is read and all its readers take it.
  std::string refusal(const Json& record) const {
    const fs::path file = folder_ / "x.json";
    std::ofstream(file) << record.dump();  // without a sync for each of thousands
    try {
      CompareOptions options;
      options.is_forced = true;
      compare({"a", {}, read_record(file)}, {"b", {}, real_}, options, [](const auto&) {});
      compare({"a", {}, real_}, {"b", {}, read_record(file)}, options, [](const auto&) {});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  const Json real_ = real_record();
  const fs::path folder_ =
      fs::temp_directory_path() / ("wavecurve_check_record_" + std::to_string(::getpid()));
};

TEST_F(CheckRecordTest, TheProjectsRecordsAreSound) {
  const History history = read_history(fs::path(WAVECURVE_SOURCE_DIR) / "benchmarks" / "history");
  EXPECT_EQ(history.refused, std::vector<std::string>());
  EXPECT_EQ(refusal(real_), "");
}

TEST_F(CheckRecordTest, ARecordWithAnyPlaceAlteredIsReadSafelyOrRefusedInOneSentence) {
  const auto refusals = [&](const Json& record) { return refusal(record); };
  EXPECT_GT(io::refused_of(io::altered(real_), refusals), 100);
}

TEST_F(CheckRecordTest, AMissingKeyIsNamedWithItsPlace) {
  const std::string kernel = real_.at("kernels").begin().key();
  for (const char* key : {"size", "instructions", "data_reads", "data_writes"}) {
    Json altered = real_;
    altered.at("kernels").at(kernel).erase(key);
    const std::string expected = "kernels." + kernel + " has no key '" + key + "'";
    EXPECT_NE(refusal(altered).find(expected), std::string::npos) << refusal(altered);
  }
  for (const char* key : {"kind", "value"}) {
    Json altered = real_;
    altered.at("accuracy").begin()->erase(key);
    EXPECT_NE(refusal(altered).find(std::string("has no key '") + key), std::string::npos);
  }
  for (const char* key : {"name", "program", "time_unit"}) {
    Json altered = real_;
    altered.at("benchmarks").at(0).erase(key);
    EXPECT_NE(refusal(altered).find(std::string("benchmarks[0] has no key '") + key),
              std::string::npos);
  }
}

}  // namespace
}  // namespace wavecurve::tracking
