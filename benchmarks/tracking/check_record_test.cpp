#include "benchmarks/tracking/check_record.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/io/files/write_file.hpp"

#include "benchmarks/tracking/compare.hpp"

namespace wavecurve::tracking {
namespace {

namespace fs = std::filesystem;

/// The latest record of the project, with two of its benchmarks.
Json real_record() {
  Json record =
      read_history(fs::path(WAVECURVE_SOURCE_DIR) / "benchmarks" / "history").records.back();
  Json& benchmarks = record.at("benchmarks");
  benchmarks.erase(benchmarks.begin() + 2, benchmarks.end());
  return record;
}

std::vector<Json::json_pointer> places_of(const Json& json,
                                          const Json::json_pointer& here = Json::json_pointer()) {
  std::vector<Json::json_pointer> places{here};
  if (!json.is_structured()) return places;
  for (const auto& [key, value] : json.items()) {
    const auto below = places_of(value, json.is_array() ? here / std::stoul(key) : here / key);
    places.insert(places.end(), below.begin(), below.end());
  }
  return places;
}

class CheckRecordTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  /// What is said of a record that is refused; empty where it is read and all its readers take it.
  std::string refusal(const Json& record) const {
    const fs::path file = folder_ / "x.json";
    io::write_file(file, record.dump());
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
  const std::vector<Json> others{nullptr, -1, 1e300, "x", true, Json::array(), Json::object()};
  int refused = 0;
  for (const Json::json_pointer& place : places_of(real_)) {
    for (const Json& other : others) {
      Json altered = real_;
      altered[place] = other;
      const std::string message = refusal(altered);
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_EQ(message.find("json.exception"), std::string::npos) << message;
      refused += message.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 100);
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
