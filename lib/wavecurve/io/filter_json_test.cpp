#include "wavecurve/io/filter_json.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::io {
namespace {

namespace fs = std::filesystem;
using Taps = std::vector<std::string>;

class FilterJson : public testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }

  UserFilter read(const std::string& text) const {
    write_file(path_, text);
    return read_filter_json(path_);
  }

  /// What is said behind the file's name.
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const std::invalid_argument& error) {
      const std::string message = error.what(), opening = path_.string() + ": ";
      EXPECT_TRUE(message.starts_with(opening)) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message.substr(std::min(opening.size(), message.size()));
    }
    return "";
  }

  fs::path path_ =
      fs::temp_directory_path() / ("wavecurve-mine-" + std::to_string(::getpid()) + ".json");
};

TEST_F(FilterJson, IsReadInBothForms) {
  const UserFilter own =
      read(R"({"taps": ["0.70710678118654752440", 0.5], "first_index": -1, "accuracy": 1e-7})");
  EXPECT_EQ(own.name, path_.stem());
  EXPECT_EQ(own.taps.first_index, -1);
  EXPECT_EQ(own.taps.taps, (Taps{"0.70710678118654752440", "0.5"}));
  EXPECT_EQ(own.sum, "sqrt2");
  EXPECT_EQ(own.accuracy, "1e-7");
  EXPECT_FALSE(own.dual.has_value());
  const UserFilter printed =
      read(R"({"filter": "x", "analysis_low": {"first_index": 1, "taps": ["1"]},
      "synthesis_low": {"first_index": 2, "taps": ["2"]}, "diagnostics": {"any": [1]}})");
  EXPECT_EQ(printed.name, "x");
  EXPECT_EQ(printed.taps.first_index, 2);
  EXPECT_EQ(printed.dual->taps.front(), "1");
}

TEST_F(FilterJson, EveryDigitOfANumberCounts) {
  const UserFilter own =
      read(R"({"taps": [0.50, 1e-3, 3, -0, 0.48296291314453414337487159986, "3/4"]})");
  EXPECT_EQ(own.taps.taps,
            (Taps{"0.50", "1e-3", "3", "0", "0.48296291314453414337487159986", "3/4"}));
}

TEST_F(FilterJson, SumAndAccuracyHoldForBothSidesOrForEach) {
  const std::string opening = R"({"taps": ["1"], "dual": {"taps": ["2"])";
  UserFilter own = read(opening + R"(}, "sum": 2, "accuracy": "1e-9"})");
  EXPECT_EQ(own.sum, "2");
  EXPECT_FALSE(own.dual_sum || own.dual_accuracy);
  for (const char* rest :
       {R"(}, "sum": {"primal": "2", "dual": "1"}, "accuracy": {"primal": 1e-9, "dual": 1e-5}})",
        R"(, "sum": "1", "accuracy": 1e-5}, "sum": "2", "accuracy": 1e-9})"}) {
    own = read(opening + rest);
    EXPECT_EQ(own.sum, "2") << rest;
    EXPECT_EQ(own.dual_sum, "1") << rest;
    EXPECT_EQ(own.accuracy, "1e-9") << rest;
    EXPECT_EQ(own.dual_accuracy, "1e-5") << rest;
  }
  EXPECT_EQ(read(opening + R"(}, "accuracy": {"dual": 1e-5}})").accuracy, std::nullopt);
  // Equal taps are one orthonormal filter only with equal sums.
  EXPECT_FALSE(read(R"({"taps": ["1"], "dual": {"taps": ["1"]}, "sum": "2"})").dual.has_value());
  EXPECT_TRUE(
      read(R"({"taps": ["1"], "dual": {"taps": ["1"], "sum": "1"}, "sum": "2"})").dual.has_value());
}

TEST_F(FilterJson, WhatIsWrongIsOneClearLine) {
  const std::pair<const char*, const char*> known[] = {
      {"", "not JSON: it is empty"},
      {" \n", "not JSON: it is empty"},
      {"{", "not JSON: line 1, column 2: '{' is not expected"},
      {"{\"taps\":\n  [1 2]}", "not JSON: line 2, column 6: '2' is not expected"},
      {R"({"taps": [1e999]})", "not JSON: line 1, column 15: '1e999' is too large a number"},
      {"[]", "the document is a list of 0, but must be an object"},
      {"3", "the document is 3, but must be an object"},
      {"{}", "the document has no key 'taps'"},
      {R"({"taps": 3})", "taps is 3, but must be a list"},
      {R"({"taps": ["1", null]})", "taps[1] is null, but must be a number, in quotes or not"},
      {R"({"taps": [[1]]})", "taps[0] is a list of 1, but must be a number, in quotes or not"},
      {R"({"taps": ["1"], "first_index": 1.5})",
       "first_index is '1.5', but must be a whole number from -1000000 to 1000000"},
      {R"({"taps": ["1"], "first_index": 99999999999})",
       "first_index is 99999999999, but must be a whole number from -1000000 to 1000000"},
      {R"({"taps": ["1"], "first_index": 18446744073709551615})",
       "first_index is 18446744073709551615, but must be a whole number from -1000000 to 1000000"},
      {R"({"taps": ["1"], "name": 3})", "name is 3, but must be a text"},
      {R"({"taps": ["1"], "sum": [2]})",
       "sum is a list of 1, but must be a number, in quotes or not"},
      {R"({"taps": ["1"], "dual": 3})", "dual is 3, but must be an object"},
      {R"({"taps": ["1"], "dual": {"taps": [true]}})",
       "dual.taps[0] is true, but must be a number, in quotes or not"},
      {R"({"taps": ["1"], "taps": ["2"]})", "key 'taps' stands twice"},
      {R"({"taps": ["1"], "accuracy": {"dual": 1e-3}})",
       "accuracy.dual is given, but there is no dual side"},
      {R"({"synthesis_low": {"taps": {}}})", "synthesis_low.taps is an object, but must be a list"},
  };
  for (const auto& [text, message] : known) EXPECT_EQ(refusal(text), message) << text;
  EXPECT_TRUE(refusal("\x01\xff\xfe").starts_with("not JSON: line 1, column 1"));
}

TEST_F(FilterJson, AnUnknownKeyIsNamedAndTheOneThatIsMeant) {
  EXPECT_EQ(refusal(R"({"taps": ["1"], "first_indx": 1})"),
            "unknown key 'first_indx'; known: name, sum, accuracy, vanishing_moments, "
            "dual_vanishing_moments, taps, first_index, dual; do you mean 'first_index'?");
  EXPECT_EQ(
      refusal(R"({"taps": ["1"], "dual": {"tap": ["1"]}})"),
      "dual: unknown key 'tap'; known: taps, first_index, sum, accuracy; do you mean 'taps'?");
  EXPECT_EQ(refusal(R"({"taps": ["1"], "colour": "red"})"),
            "unknown key 'colour'; known: name, sum, accuracy, vanishing_moments, "
            "dual_vanishing_moments, taps, first_index, dual");
  EXPECT_NE(refusal(R"({"taps": ["1"], "accuracy": {"prime": 1}})").find("do you mean 'primal'?"),
            std::string::npos);
}

TEST_F(FilterJson, DepthAndSizeAreBounded) {
  const auto nested = [](const char* open, const char* close, int deep) {
    std::string text = R"({"name": )";
    for (int i = 0; i < deep; ++i) text += open;
    text += "1";
    for (int i = 0; i < deep; ++i) text += close;
    return text + "}";
  };
  for (const int deep : {100, 100000}) {
    EXPECT_EQ(refusal(nested("[", "]", deep)), "the document is nested more than 100 deep");
    EXPECT_EQ(refusal(nested("{\"a\":", "}", deep)), "the document is nested more than 100 deep");
  }
  EXPECT_EQ(refusal(nested("[", "]", 99)), "name is a list of 1, but must be a text");
  try {
    read(std::string((1 << 20) + 1, ' '));
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), "cannot read " + path_.string() + ": it is larger than 1048576 bytes");
  }
}

}  // namespace
}  // namespace wavecurve::io
