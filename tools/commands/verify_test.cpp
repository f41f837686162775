#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class VerifyCommand : public ProgramTest {
 protected:
  /// The program's `verify` with a reference and a report of this test's own.
  ProgramRun verify(const std::string& arguments, const std::string& environment = "") const {
    return run(environment + " '" WAVECURVE_PROGRAM "' verify --reference '" + reference.string() +
               "' " + arguments);
  }
  ProgramRun verify_into_report(const std::string& arguments) const {
    return verify("--output '" + report.string() + "' " + arguments);
  }

  const fs::path directory = folder_;
  const fs::path reference = directory / "verdicts.json";
  const fs::path report = directory / "report";
};

TEST_F(VerifyCommand, ListsTheClaims) {
  const ProgramRun list = run("'" WAVECURVE_PROGRAM "' verify --list");
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_TRUE(has(list.out, "erratum-2-5"));
  EXPECT_TRUE(has(list.out, "(Section 3.3, (3.15))"));
}

TEST_F(VerifyCommand, BlessesThenAgreesThenNamesWhatChanged) {
  const ProgramRun missing = verify_into_report("--only erratum-2-5 erratum-3-16");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_TRUE(has(missing.err, "verdicts.json: No such file")) << missing.err;
  EXPECT_EQ(verify_into_report("--only erratum-2-5 erratum-3-16 --bless").exit_code, 0);
  const ProgramRun same = verify_into_report("--only erratum-2-5");
  EXPECT_EQ(same.exit_code, 0) << same.out;
  EXPECT_TRUE(has(same.out, "erratum-2-5  does-not-hold  ")) << same.out;
  EXPECT_TRUE(has(same.out, "1 claim: 1 does-not-hold\n"));
  EXPECT_EQ(same.err, "") << "no progress where nobody watches";

  auto blessed = nlohmann::json::parse(io::read_file(reference));
  blessed["claims"][0]["verdict"] = "holds";
  io::write_file(reference, blessed.dump());
  const ProgramRun changed = verify_into_report("--only erratum-2-5 erratum-3-16");
  EXPECT_EQ(changed.exit_code, 1);
  EXPECT_TRUE(has(changed.out, "  erratum-2-5: verdict: blessed holds, own does-not-hold\n"));
  EXPECT_FALSE(has(changed.out, "erratum-3-16: "));
}

TEST_F(VerifyCommand, NamesTheClaimTheValueAndBothNumbersOfEachValueThatDiffers) {
  ASSERT_EQ(verify_into_report("--only erratum-2-5 --bless").exit_code, 0);
  const auto blessed = nlohmann::json::parse(io::read_file(reference));
  const auto differs_with = [&](const nlohmann::json& values) {
    auto changed = blessed;
    changed["claims"][0]["values"] = values;
    io::write_file(reference, changed.dump());
    const ProgramRun result = verify_into_report("--only erratum-2-5");
    EXPECT_EQ(result.exit_code, 1) << result.out;
    const auto at = result.out.find("  erratum-2-5: ");
    return at == std::string::npos ? result.out : result.out.substr(at);
  };
  const auto values = blessed["claims"][0]["values"];
  ASSERT_EQ(values.size(), 2u);

  auto other = values;
  other[0]["number"] = 257;
  EXPECT_EQ(differs_with(other),
            "  erratum-2-5: value functions from M_f on: blessed 257 (tolerance 0), own 256\n");
  EXPECT_EQ(differs_with(nlohmann::json::array({values[0]})),
            "  erratum-2-5: value dimension of their space: blessed no such value, own 128\n");
  auto more = values;
  more.push_back(values[0]);
  more[2]["name"] = "rows";
  EXPECT_EQ(differs_with(more), "  erratum-2-5: value rows: blessed 256, own no such value\n");
}

TEST_F(VerifyCommand, WordsAreFreeAndAToleranceIsMinded) {
  ASSERT_EQ(verify_into_report("--only erratum-3-15 --bless").exit_code, 0);
  auto blessed = nlohmann::json::parse(io::read_file(reference));
  auto& value = blessed["claims"][0]["values"][0];
  const double number = value["number"].get<double>();
  value["tolerance"] = 2;
  value["reason"] = "Other words.";
  for (const auto& [distance, exit_code] : {std::pair{2, 0}, {-2, 0}, {3, 1}}) {
    value["number"] = number + distance;
    io::write_file(reference, blessed.dump());
    EXPECT_EQ(verify_into_report("--only erratum-3-15").exit_code, exit_code) << distance;
  }
}

TEST_F(VerifyCommand, TwoRunsGiveTheSameBytesApartFromTheDate) {
  const std::string arguments = "--bless --only erratum-3-15 --output ";
  ASSERT_EQ(verify(arguments + (directory / "a").string(), "SOURCE_DATE_EPOCH=1").exit_code, 0);
  ASSERT_EQ(verify(arguments + (directory / "b").string(), "SOURCE_DATE_EPOCH=1").exit_code, 0);
  EXPECT_EQ(run("diff -r '" + (directory / "a").string() + "' '" + (directory / "b").string() + "'")
                .exit_code,
            0);
  EXPECT_TRUE(fs::exists(directory / "a" / "figures" / "erratum-3-15-motion.gp"));
}

TEST_F(VerifyCommand, RefusesAnUnknownClaimInOneLine) {
  const ProgramRun unknown = verify_into_report("--only no-such-claim");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(has(unknown.err, "no-such-claim") && has(unknown.err, "--list")) << unknown.err;
  EXPECT_EQ(unknown.err.find('\n'), unknown.err.size() - 1);
  EXPECT_EQ(unknown.out, "");
}

TEST_F(VerifyCommand, RefusesABrokenReference) {
  io::write_file(reference, "not json");
  EXPECT_EQ(verify_into_report("--only erratum-2-5").exit_code, 2);
}

TEST_F(VerifyCommand, RefusesAReferenceOfAnotherVersionInOneLine) {
  io::write_file(reference, "{\"schema\": 3, \"claims\": []}");
  const ProgramRun newer = verify_into_report("--only erratum-2-5");
  EXPECT_EQ(newer.exit_code, 2);
  EXPECT_TRUE(has(newer.err, "verdicts.json: schema version 3, but")) << newer.err;
  EXPECT_EQ(newer.err.find('\n'), newer.err.size() - 1);
  EXPECT_EQ(newer.out, "");
}

TEST_F(VerifyCommand, SaysWhereTheReportCannotBeWritten) {
  io::write_file(directory / "file", "");
  const ProgramRun unwritable = verify("--bless --only erratum-2-5 --output '" +
                                       (directory / "file" / "report").string() + "'");
  EXPECT_EQ(unwritable.exit_code, 3);
  EXPECT_TRUE(has(unwritable.err, "file/report")) << unwritable.err;
}

TEST_F(VerifyCommand, NamesThePackageOfAMissingGnuplot) {
  const ProgramRun missing =
      verify("--bless --only erratum-3-15 --output '" + report.string() + "'", "PATH=/nonexistent");
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_TRUE(has(missing.err, "gnuplot-nox")) << missing.err;
}

}  // namespace
}  // namespace wavecurve::tools
