#include <regex>

#include <nlohmann/json.hpp>

#include "wavecurve/certified/detail/families/families.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

using FilterCommand = ProgramTest;
using nlohmann::json;

TEST_F(FilterCommand, JsonHoldsEveryTapCorrectlyRounded) {
  const json document = json::parse(wavecurve("filter D8 --digits 25 --format json").out);
  EXPECT_EQ(document["filter"], "db4");
  EXPECT_EQ(document["analysis_low"]["first_index"], 0);
  const auto low = certified::find_filter("db4").bank(300).analysis_low;
  for (int n = 0; n < low.size(); ++n) {
    EXPECT_EQ(document["analysis_low"]["taps"][n], *certified::round_to_digits(low[n], 25));
  }
  EXPECT_EQ(document["diagnostics"]["vanishing_moments"], 4);
  EXPECT_EQ(document["diagnostics"]["riesz_bounds"],
            json::parse(R"(["1.000000000", "1.000000000"])"));
}

TEST_F(FilterCommand, ListsEveryFilterAndAlias) {
  const ProgramRun list = wavecurve("filter --list");
  EXPECT_EQ(list.exit_code, 0);
  const auto has_line = [&](const std::string& line) {
    return ("\n" + list.out).find("\n" + line + "\n") != std::string::npos;
  };
  EXPECT_TRUE(has_line("  db4         D8, d8")) << list.out;
  EXPECT_TRUE(has_line("  coif2       K2, c12")) << list.out;
  for (const certified::Family& family : certified::families()) {
    EXPECT_TRUE(has_line(family.names)) << family.names;
    for (const auto& [alias, name] : family.aliases) {
      EXPECT_TRUE(std::regex_search(
          list.out, std::regex("\n  " + name + " +([^\n]*, )?" + alias + "(,[^\n]*)?\n")))
          << alias;
    }
  }
  for (const std::string& name : certified::filter_names()) {
    EXPECT_TRUE(std::regex_search(list.out, std::regex("\n  " + name + "( [^\n]*)?\n"))) << name;
  }
}

TEST_F(FilterCommand, ItsJsonIsAFilterFileAgain) {
  for (const std::string name : {"sym5", "cdf9.7", "bspline3.3"}) {
    io::write_file(folder_ / "own.json",
                   wavecurve("filter " + name + " --format json --digits 30").out);
    const ProgramRun again = wavecurve("filter own.json --format json --digits 20");
    ASSERT_EQ(again.exit_code, 0) << again.err;
    const json first = json::parse(wavecurve("filter " + name + " --format json --digits 20").out);
    EXPECT_EQ(json::parse(again.out)["synthesis_low"], first["synthesis_low"]) << name;
    EXPECT_EQ(json::parse(again.out)["analysis_high"], first["analysis_high"]) << name;
  }
}

TEST_F(FilterCommand, TheHeaderCompilesToTheLibrarysTaps) {
  io::write_file(folder_ / "filter.hpp", wavecurve("filter cdf9.7 --format cpp").out);
  io::write_file(
      folder_ / "main.cpp",
      "#include <cstdio>\n#include \"filter.hpp\"\nint main() {\n"
      "  for (double tap : wavecurve_tables::cdf9_7::synthesis_low) std::printf(\"%a\\n\", tap);\n"
      "}\n");
  const ProgramRun built = run("c++ -std=c++17 -o '" + (folder_ / "a.out").string() + "' '" +
                               (folder_ / "main.cpp").string() + "'");
  ASSERT_EQ(built.exit_code, 0) << built.err;
  std::string expected;
  for (const double tap : find_filter_bank("cdf9.7").synthesis_low.taps) {
    char line[64];
    std::snprintf(line, sizeof line, "%a\n", tap);
    expected += line;
  }
  EXPECT_EQ(run("'" + (folder_ / "a.out").string() + "'").out, expected);
}

TEST_F(FilterCommand, CsvHasALineATap) {
  const std::string csv = wavecurve("filter K1 --format csv --digits 12").out;
  EXPECT_TRUE(csv.starts_with("filter,part,index,tap\ncoif1,analysis_low,-2,")) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 4 * 6);
}

TEST_F(FilterCommand, TextNamesTheDiagnostics) {
  const std::string text = wavecurve("filter bspline4.4").out;
  for (const char* part :
       {"vanishing moments", "support", "sobolev exponent", "riesz bounds", "symmetry"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
}

TEST_F(FilterCommand, RefusesBadInput) {
  expect_refusal("filter nope", "unknown filter 'nope'");
  expect_refusal("filter fk8", "filter 'fk8' is a Fejer-Korovkin filter, whose taps");
  expect_refusal("filter db39", "the order of filter db39 is 39, but must be from 1 to 38");
  expect_refusal("filter bspline3.4", "must be even");
  expect_refusal("filter db4 --digits 0", "--digits");
  expect_refusal("filter db4 --format xml", "--format");
  expect_refusal("filter missing.json", "missing.json");
  expect_refusal("filter", "NAME");
  expect_refusal("", "subcommand");
  io::write_file(folder_ / "bad.json", R"({"taps": ["0.5", "0.5"]})");
  expect_refusal("filter bad.json", "violates sum_k synthesis_low_k = sqrt 2 by 6e-1");
  io::write_file(folder_ / "worse.json",
                 R"({"taps": ["0.70710678118", "0.70710678119"], "vanishing_moments": 2})");
  expect_refusal("filter worse.json", "violates sum_k (-1)^k k^1 synthesis_low_k = 0 by 8e-1");
}

TEST_F(FilterCommand, AFilterOfFewDigitsIsAcceptedForWhatItIs) {
  io::write_file(folder_ / "rough.json", R"({"taps": ["0.5", "0.8", "0.2", "-0.1"]})");
  EXPECT_EQ(wavecurve("filter rough.json").exit_code, 0);
  expect_refusal("coefficients rough.json", "taps have too few digits");
}

// A line of code, a keyword, what the compiler defines, what it keeps for itself, a comment that
// would go on.
TEST_F(FilterCommand, AnyNameGivesAHeaderThatCompiles) {
  io::write_file(folder_ / "main.cpp", "#include \"own.hpp\"\nint main() {}\n");
  for (const char* name : {R"(x\n#error no comment\n//)", "int", "linux", "__x", "9/7", "",
                           R"(x\\)", R"(\u00e9*/ \u2028)", "?\?/"}) {
    io::write_file(folder_ / "own.json",
                   std::string(R"({"taps": ["1", "1"], "sum": "2", "name": ")") + name + "\"}");
    for (const char* command : {"filter", "coefficients --derivatives 0,0"}) {
      const ProgramRun header = wavecurve(std::string(command) + " own.json --format cpp");
      ASSERT_EQ(header.exit_code, 0) << header.err;
      io::write_file(folder_ / "own.hpp", header.out);
      const ProgramRun built = run("c++ -std=c++17 -trigraphs -Werror -Wall -fsyntax-only '" +
                                   (folder_ / "main.cpp").string() + "'");
      EXPECT_EQ(built.exit_code, 0) << name << "\n" << built.err << header.out;
    }
  }
}

TEST_F(FilterCommand, TablesOfDoubleArithmeticAreReadWithTheirAccuracy) {
  // db2 as a much used package printed it for years.
  const std::string taps =
      R"({"taps": [0.48296291314469025, 0.836516303737469, 0.22414386804185735, -0.12940952255092145])";
  io::write_file(folder_ / "own.json", taps + "}");
  const ProgramRun refused = wavecurve("filter own.json");
  const std::string opening = "with \"accuracy\": \"";
  const auto place = refused.err.find(opening);
  ASSERT_NE(place, std::string::npos) << refused.err;
  const std::string accuracy = refused.err.substr(place + opening.size());
  io::write_file(folder_ / "own.json",
                 taps + ", \"accuracy\": " + accuracy.substr(0, accuracy.find('"')) + "}");
  const json document = json::parse(wavecurve("filter own.json --format json").out);
  EXPECT_EQ(document["diagnostics"]["vanishing_moments"], 2);
  EXPECT_EQ(document["synthesis_low"]["taps"][1], "0.83651630374");
  // Whether the taps that are meant have just as many moments, inaccurate ones cannot say.
  const std::string moments = "vanishing moments       2";
  EXPECT_NE(wavecurve("filter own.json").out.find(moments + ", to the accuracy of the taps\n"),
            std::string::npos);
  EXPECT_NE(wavecurve("filter db2").out.find(moments + "\n"), std::string::npos);
}

// Each took from ten seconds to for ever.
TEST_F(FilterCommand, ManyTapsAndFewDigitsTakeSeconds) {
  const auto lazy = [](int taps) {
    std::string text = R"({"sum": "2", "taps": ["1")";
    for (int i = 2; i < taps; ++i) text += ", \"0\"";
    return text + ", \"1\"]}";
  };
  for (const int taps : {50, 100, 200}) {
    io::write_file(folder_ / "own.json", lazy(taps));
    EXPECT_EQ(
        run("timeout 20 '" WAVECURVE_PROGRAM "' filter '" + (folder_ / "own.json").string() + "'")
            .exit_code,
        0)
        << taps;
  }
  io::write_file(folder_ / "own.json",
                 R"({"taps":["0.353553","0.707107","0.353553"],"first_index":-1,
          "dual":{"taps":["-0.176777","0.353553","1.060660","0.353553","-0.176777"],"first_index":-2}})");
  EXPECT_EQ(
      run("timeout 20 '" WAVECURVE_PROGRAM "' filter '" + (folder_ / "own.json").string() + "'")
          .exit_code,
      0);
  for (const char* tap : {"0.001", "1e-10000"}) {
    std::string text = R"({"taps": [)";
    for (int i = 0; i < 1000; ++i) text += (i == 0 ? "\"" : ", \"") + std::string(tap) + "\"";
    io::write_file(folder_ / "own.json", text + "]}");
    expect_refusal(
        "filter own.json",
        tap[0] == '0'
            ? "the number of taps of filter own is 1000, but must be from 1 to 256"
            : "taps[0] of filter own: the exponent of '1e-10000' is -10000, but must be from -1000");
  }
}

TEST_F(FilterCommand, AFullDiskIsTheEnvironmentsFault) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_EQ(run("{ '" WAVECURVE_PROGRAM "' filter db4 >/dev/full; }").exit_code, 3);
}

}  // namespace
}  // namespace wavecurve::tools
