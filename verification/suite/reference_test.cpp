#include "verification/suite/reference.hpp"

#include <stdexcept>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::verification {
namespace {

ClaimResult result(std::string id, Verdict verdict, std::string own_value) {
  return {{std::move(id), "", "", "", {}}, {verdict, std::move(own_value), "", {}}};
}

class Reference : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(directory); }
  void TearDown() override { std::filesystem::remove_all(directory); }

  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("wavecurve_reference_" + std::to_string(getpid()));
  const std::filesystem::path file = directory / "verdicts.json";
  const std::vector<ClaimResult> blessed = {result("table-1", Verdict::certified, "all 12"),
                                            result("figure-3", Verdict::holds, "736 \"entries\"")};
};

TEST_F(Reference, WhatIsWrittenIsReadBack) {
  write_reference(file, blessed, false);
  const auto read = read_reference(file);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[1], (BlessedClaim{"figure-3", "holds", "736 \"entries\""}));
  EXPECT_TRUE(compare(read, blessed, false).empty());
}

TEST_F(Reference, NamesEachChange) {
  write_reference(file, blessed, false);
  const std::vector<ClaimResult> run = {result("table-1", Verdict::misprint, "all 11"),
                                        result("table-2", Verdict::holds, "new")};
  const auto changes = compare(read_reference(file), run, false);
  const std::vector<Change> expected = {{"table-1", "verdict", "certified", "misprint"},
                                        {"table-1", "own_value", "all 12", "all 11"},
                                        {"table-2", "claim", "not in the reference", "holds"},
                                        {"figure-3", "claim", "holds", "no such claim"}};
  EXPECT_EQ(changes, expected);
}

TEST_F(Reference, APartialRunMissesNothingAndBlessesOnlyItself) {
  write_reference(file, blessed, false);
  const std::vector<ClaimResult> run = {result("table-1", Verdict::form, "all 12")};
  EXPECT_EQ(compare(read_reference(file), run, true).size(), 1u);
  write_reference(file, run, true);
  const auto read = read_reference(file);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].verdict, "form");
  EXPECT_EQ(read[1].id, "figure-3");
  write_reference(file, run, false);
  EXPECT_EQ(read_reference(file).size(), 1u);
}

TEST_F(Reference, NoFileIsAnEmptyReferenceAndAWrongOneIsRefusedByName) {
  EXPECT_TRUE(read_reference(directory / "none.json").empty());
  for (const char* text : {"", "[]", "{\"claims\": [{\"id\": 3}]}", "\x7f\x45\x4c\x46"}) {
    io::write_file(file, text);
    try {
      read_reference(file);
      FAIL() << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("verdicts.json"), std::string::npos);
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
