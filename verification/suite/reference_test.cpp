#include "verification/suite/reference.hpp"

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::verification {
namespace {

ClaimResult result(std::string id, ClaimVerdict verdict, std::vector<ClaimValue> values,
                   std::string_view words = "") {
  return {{std::move(id), "", "", "", {}}, {verdict, {words, std::move(values)}, "", {}}};
}

class Reference : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(directory); }
  void TearDown() override { std::filesystem::remove_all(directory); }

  /// The changes of a run of the claim "sparse" alone, as lines.
  std::vector<std::string> changes_with(std::vector<ClaimValue> values,
                                        std::string_view words = "") const {
    write_reference(file, blessed, false);
    const std::vector<ClaimResult> run = {
        result("sparse", ClaimVerdict::holds, std::move(values), words)};
    std::vector<std::string> lines;
    for (const Change& change : compare(read_reference(file), run, true)) {
      lines.push_back(change.id + ", " + change.what + ": " + change.blessed + " | " + change.own);
    }
    return lines;
  }

  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("wavecurve_reference_" + std::to_string(getpid()));
  const std::filesystem::path file = directory / "verdicts.json";
  const ClaimValue entries = counted("\"entries\"", 736),
                   share = to_decimals("share", 46.3, 1, "%");
  const std::vector<ClaimResult> blessed = {
      result("table-1", ClaimVerdict::certified, {counted("certified", 12)}),
      result("sparse", ClaimVerdict::holds, {entries, share}, "{} entries")};
};

TEST_F(Reference, WhatIsWrittenIsReadBack) {
  write_reference(file, blessed, false);
  const auto read = read_reference(file);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[1], (BlessedClaim{"sparse", "holds", {entries, share}}));
  EXPECT_TRUE(compare(read, blessed, false).empty());
}

TEST_F(Reference, NamesEachChange) {
  write_reference(file, blessed, false);
  const std::vector<ClaimResult> run = {
      result("table-1", ClaimVerdict::form, {counted("certified", 11)}),
      result("table-2", ClaimVerdict::holds, {})};
  const std::vector<Change> expected = {{"table-1", "verdict", "certified", "form"},
                                        {"table-1", "value certified", "12 (tolerance 0)", "11"},
                                        {"table-2", "claim", "no such claim", "holds"},
                                        {"sparse", "claim", "holds", "no such claim"}};
  EXPECT_EQ(compare(read_reference(file), run, false), expected);
}

TEST_F(Reference, WordsAndTheOrderOfValuesAreFree) {
  EXPECT_TRUE(changes_with({share, entries}, "other words: {1}").empty());
}

TEST_F(Reference, ValuesAreComparedWithinTheirTolerance) {
  const auto with_share = [&](double percent, int decimals) {
    return changes_with({entries, to_decimals("share", percent, decimals, "%")});
  };
  EXPECT_TRUE(with_share(46.34, 1).empty());
  EXPECT_TRUE(with_share(46.35, 2).empty());
  EXPECT_EQ(with_share(46.36, 2),
            (std::vector<std::string>{"sparse, value share: 46.3 % (tolerance 0.05) | 46.36 %"}));
  EXPECT_EQ(changes_with({counted(entries.name, 735), share}),
            (std::vector<std::string>{"sparse, value \"entries\": 736 (tolerance 0) | 735"}));
}

TEST_F(Reference, MissingAdditionalAndRenamedValuesAreChanges) {
  const std::string missing = "sparse, value share: 46.3 % | no such value";
  EXPECT_EQ(changes_with({entries}), (std::vector<std::string>{missing}));
  EXPECT_EQ(changes_with({entries, share, counted("rows", 64)}),
            (std::vector<std::string>{"sparse, value rows: no such value | 64"}));
  EXPECT_EQ(changes_with({entries, to_decimals("part", 46.3, 1, "%")}),
            (std::vector<std::string>{missing, "sparse, value part: no such value | 46.3 %"}));
}

TEST_F(Reference, APartialRunMissesNothingAndBlessesOnlyItself) {
  write_reference(file, blessed, false);
  const std::vector<ClaimResult> run = {
      result("table-1", ClaimVerdict::form, {counted("certified", 12)})};
  EXPECT_EQ(compare(read_reference(file), run, true).size(), 1u);
  write_reference(file, run, true);
  const auto read = read_reference(file);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].verdict, "form");
  EXPECT_EQ(read[1].id, "sparse");
  write_reference(file, run, false);
  EXPECT_EQ(read_reference(file).size(), 1u);
}

TEST_F(Reference, RunsThatBlessAtOnceLoseNothing) {
  for (int round = 0; round < 50; ++round) {
    std::filesystem::remove(file);
    std::vector<std::jthread> runs;
    for (const ClaimResult& claim : blessed) {
      runs.emplace_back([&] { write_reference(file, std::span(&claim, 1), true); });
    }
    runs.clear();
    ASSERT_EQ(read_reference(file).size(), blessed.size());
  }
}

TEST_F(Reference, WhatFailedIsNeitherComparedNorBlessed) {
  write_reference(file, blessed, false);
  ClaimResult failed = result("sparse", ClaimVerdict::undecided, {});
  failed.outcome.failure = "no root in the box";
  const std::vector<ClaimResult> run = {blessed[0], failed};
  EXPECT_TRUE(compare(read_reference(file), run, false).empty());
  write_reference(file, run, false);
  EXPECT_EQ(read_reference(file)[1], (BlessedClaim{"sparse", "holds", {entries, share}}));
  std::filesystem::remove(file);
  write_reference(file, run, false);
  EXPECT_EQ(read_reference(file).size(), 1u);
}

TEST_F(Reference, AMissingOrWrongFileIsRefusedByName) {
  EXPECT_THROW(read_reference(directory / "none.json"), std::invalid_argument);
  const std::string value =
      R"({"name": "n", "number": null, "unit": "", "decimals": 1, "tolerance": 0})";
  const std::string claim = R"({"schema": 2, "claims": [{"id": "x", "verdict": "holds")";
  for (const std::string& text :
       {std::string(), std::string("[]"), std::string("\x7f\x45\x4c\x46"), claim + "}]}",
        std::string(R"({"schema": 2, "claims": [{"id": 3}]})"),
        std::string(R"({"schema": 2, "claims": [{"id": "x", "verdict": "so", "values": []}]})"),
        claim + R"(, "values": [)" + value + "]}]}"}) {
    io::write_file(file, text);
    try {
      read_reference(file);
      FAIL() << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("verdicts.json"), std::string::npos);
    }
  }
}

TEST_F(Reference, AnotherSchemaVersionIsRefusedByNumber) {
  for (const auto& [schema, number] : {std::pair{"\"schema\": 3, ", "version 3,"},
                                       {"", "version 1,"},
                                       {"\"schema\": \"new\", ", "version \"new\","}}) {
    io::write_file(file, std::string("{") + schema + "\"claims\": []}");
    try {
      read_reference(file);
      FAIL() << number;
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find("verdicts.json: schema "), std::string::npos) << text;
      EXPECT_NE(text.find(number), std::string::npos) << text;
      EXPECT_NE(text.find("reads version 2"), std::string::npos) << text;
    }
  }
}

TEST_F(Reference, WritingTwiceGivesTheSameBytes) {
  write_reference(file, blessed, false);
  const std::string first = io::read_file(file);
  const std::vector<ClaimResult> reversed(blessed.rbegin(), blessed.rend());
  write_reference(file, reversed, false);
  EXPECT_EQ(io::read_file(file), first);
}

}  // namespace
}  // namespace wavecurve::verification
