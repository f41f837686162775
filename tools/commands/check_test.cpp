#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

/// An added sign, a wrong digit, a lost sign.
const std::string wrong_table =
    "# filter: D8\n# quantity: h\nindex,printed\n"
    "0,0.23037781\n1,-0.71484657\n2,0.63188077\n3,-0.02798377\n"
    "4,0.18703481\n5,0.03084138\n6,0.03288301\n7,-0.01059740\n";

class CheckCommand : public ProgramTest {
 protected:
  // In quotes for the shell: the folder of the sources may have a blank in its path.
  const std::string table_1_ = "'" WAVECURVE_SOURCE_DIR "/verification/published/table_1.csv'";
  const std::string table_2_ = "'" WAVECURVE_SOURCE_DIR "/verification/published/table_2.csv'";
};

TEST_F(CheckCommand, ExitsWithZeroIfEveryValueIsRight) {
  const ProgramRun result = wavecurve("check " + table_1_);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("24 certified"), std::string::npos);
  EXPECT_TRUE(result.err.empty());
}

TEST_F(CheckCommand, ExitsWithOneIfAValueIsNot) {
  const ProgramRun result = wavecurve("check " + table_2_);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("13 published-route"), std::string::npos);
  EXPECT_NE(result.out.find("eigenvalue nearest zero"), std::string::npos);
}

TEST_F(CheckCommand, PrintsJson) {
  const ProgramRun result = wavecurve("check " + table_2_ + " --format json");
  const auto json = nlohmann::json::parse(result.out);
  ASSERT_EQ(json["rows"].size(), 36U);
  const auto& row = json["rows"][31];  // nu_7
  EXPECT_EQ(row["filter"], "K2");
  EXPECT_EQ(row["quantity"], "nu/nu0");
  EXPECT_EQ(row["index"], 7);
  EXPECT_EQ(row["printed"], "-0.00000270434");
  EXPECT_EQ(row["verdict"], "misprint");
  EXPECT_EQ(row["certified"], "-0.000000270434");
  const auto& print = json["rows"][1];  // alpha_1
  EXPECT_EQ(print["parts"], (nlohmann::json{{{"text", "1.20035616472"}, {"departs", false}},
                                            {{"text", "3"}, {"departs", true}}}));
  EXPECT_NEAR(row["ulps"].get<double>(), 243391, 1);
  EXPECT_NE(row["detail"].get<std::string>().find("-0.000000270434"), std::string::npos);
  EXPECT_EQ(
      json["counts"],
      (nlohmann::json{{"certified", 16}, {"form", 2}, {"misprint", 5}, {"published-route", 13}}));
  EXPECT_EQ(json["columns"].size(), 3U);
  EXPECT_EQ(json["columns"][1]["matched"], 12);
}

TEST_F(CheckCommand, PrintsCsv) {
  const ProgramRun result = wavecurve("check " + table_1_ + " --format csv");
  EXPECT_TRUE(
      result.out.starts_with("filter,quantity,index,printed,verdict,certified,ulps,detail,route\n"
                             "D8,alpha,0,2.000000000000,certified,2.000000000000,0,,\n"));
}

TEST_F(CheckCommand, ShowsExtraColumnsInEveryFormat) {
  io::write_file(folder_ / "t.csv",
                 "# filter: D8\n# quantity: mu\nIndex;Value;page;verdict\n"
                 "0;342643/82248;12;\"a, b\"\n1;-2,6;13;\n");
  EXPECT_NE(wavecurve("check t.csv").out.find("a, b"), std::string::npos);
  const auto rows = nlohmann::json::parse(wavecurve("check t.csv --format json").out)["rows"];
  EXPECT_EQ(rows[0]["extra"], (nlohmann::json{{"page", "12"}, {"verdict", "a, b"}}));
  EXPECT_TRUE(rows[0]["ulps"].is_null()) << "a fraction has no last digit";
  EXPECT_EQ(rows[0]["certified"], "342643/82248");
  EXPECT_EQ(rows[1]["printed"], "-2,6");
  EXPECT_EQ(rows[1]["verdict"], "certified");
  const std::string csv = wavecurve("check t.csv --format csv").out;
  EXPECT_TRUE(csv.starts_with(
      "filter,quantity,index,printed,verdict,certified,ulps,detail,route,page,verdict (2)\n"))
      << csv;
  EXPECT_NE(csv.find(",exactly this fraction,,12,\"a, b\"\n"), std::string::npos) << csv;
}

TEST_F(CheckCommand, ReadsItsOwnTable) {
  io::write_file(folder_ / "own.csv", wavecurve("check " + table_1_ + " --format csv").out);
  EXPECT_EQ(wavecurve("check own.csv").exit_code, 0);
}

TEST_F(CheckCommand, RefusesWhatHasNoEndOrNoBound) {
  if (std::filesystem::exists("/dev/zero"))
    expect_refusal("check /dev/zero", "larger than 67108864");
  io::write_file(folder_ / "t.csv", "filter,quantity,index,printed\nD8,mu,-2147483648,1\n");
  expect_refusal("check t.csv", "t.csv:2: the index '-2147483648' is out of range");
}

TEST_F(CheckCommand, ExplainsWithCaretsWhereAPrintDeparts) {
  io::write_file(folder_ / "t.csv", wrong_table);
  const std::string out = wavecurve("check t.csv --explain").out;
  EXPECT_NE(out.find("\nD8      h         1      -0.71484657  0.71484657   "), std::string::npos)
      << out;
  EXPECT_NE(out.find("\n" + std::string(25, ' ') + "^\n"), std::string::npos) << out;
  EXPECT_NE(out.find("\n" + std::string(29, ' ') + "^\n"), std::string::npos) << out;
  EXPECT_NE(out.find("\n" + std::string(24, ' ') + "^\n"), std::string::npos)
      << "a lost sign: " << out;
  EXPECT_EQ(std::ranges::count(out, '^'), 3);
  EXPECT_EQ(wavecurve("check t.csv").out.find('^'), std::string::npos);
  EXPECT_EQ(wavecurve("check " + table_1_ + " --explain").out.find('^'), std::string::npos);
  expect_refusal("check t.csv --explain --format json", "text with --explain");
}

/// A terminal that a test reads. It has no name where the system gives none: in a chroot without /dev/pts.
class PseudoTerminal {
 public:
  PseudoTerminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0) return;
    if (const char* name = ::ptsname(master_)) name_ = name;
    // As long as one holds it open, what was written stays to be read.
    if (!name_.empty()) held_ = ::open(name_.c_str(), O_RDWR | O_NOCTTY);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  ~PseudoTerminal() {
    if (held_ >= 0) ::close(held_);
    if (master_ >= 0) ::close(master_);
  }

  bool is_open() const { return held_ >= 0; }
  const std::string& name() const { return name_; }

  std::string read() const {
    constexpr std::size_t most = 1 << 16;
    std::string text(most, '\0');
    const auto count = ::read(master_, text.data(), text.size());
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return text;
  }

 private:
  int master_, held_ = -1;
  std::string name_;
};

TEST_F(CheckCommand, ColoursDepartingDigitsOnATerminalOnly) {
  if (!PseudoTerminal().is_open()) GTEST_SKIP() << "no pseudo-terminal: is /dev/pts mounted?";
  io::write_file(folder_ / "t.csv", wrong_table);
  const auto shown = [&](const std::string& environment) {
    const PseudoTerminal terminal;
    run("cd '" + folder_.string() + "' && " + environment +
        " '" WAVECURVE_PROGRAM "' check t.csv >" + terminal.name() + " 2>&1 || echo");
    return terminal.read();
  };
  const std::string coloured = shown("env -u NO_COLOR TERM=xterm");
  EXPECT_NE(coloured.find("0.63\x1b[1;31m1\x1b[0m88077"), std::string::npos) << coloured;
  EXPECT_NE(coloured.find("\x1b[1;31m-\x1b[0m0.71484657"), std::string::npos) << coloured;
  EXPECT_NE(coloured.find(" \x1b[41m \x1b[0m0.18703481"), std::string::npos) << coloured;
  EXPECT_NE(coloured.find(" 0.23037781 "), std::string::npos) << coloured;
  for (const char* environment : {"env NO_COLOR=1 TERM=xterm", "env -u NO_COLOR TERM=dumb"}) {
    const std::string plain = shown(environment);
    EXPECT_NE(plain.find("0.63188077"), std::string::npos) << plain;
    EXPECT_EQ(plain.find('\x1b'), std::string::npos) << plain;
  }
  EXPECT_EQ(wavecurve("check t.csv").out.find('\x1b'), std::string::npos);
}

TEST_F(CheckCommand, WritesAPage) {
  io::write_file(folder_ / "t.csv", "# title: <b>One</b> & two\n" + wrong_table);
  const ProgramRun result = wavecurve("check t.csv -o page.html");
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_NE(result.out.find("0.63188077"), std::string::npos) << "the terminal has its table, too";
  const std::string page = io::read_file(folder_ / "page.html");
  for (const char* part :
       {"<h1>&lt;b&gt;One&lt;/b&gt; &amp; two</h1>", "<code>0.63<mark>1</mark>88077</code>",
        "<code><mark>-</mark>0.71484657</code>", "a sign is missing", "<code>0.23037781</code>",
        "<tr data-verdict=\"certified\">", "value=\"misprint\" checked",
        "<h2>What the verdicts mean",
        "column by column</h2>\n<ul class=\"sentences\">\n<li>D8 h (8 decimals): "}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  for (const char* network : {"http:", "https:", "src=", "href=", "@import", "url("}) {
    EXPECT_EQ(page.find(network), std::string::npos) << network;
  }
}

TEST_F(CheckCommand, RefusesAPageThatCannotBe) {
  io::write_file(folder_ / "t.csv", wrong_table);
  expect_refusal("check t.csv -o t.csv", "a file ending in .html");
  EXPECT_EQ(io::read_file(folder_ / "t.csv"), wrong_table) << "nothing is lost";
  EXPECT_EQ(wavecurve("check t.csv -o no/such/folder/page.html").exit_code, 3);
}

TEST_F(CheckCommand, TwoRunsGiveTheSameBytes) {
  const std::string arguments = "check " + table_2_ + " --format json";
  EXPECT_EQ(wavecurve(arguments).out, wavecurve(arguments).out);
}

TEST_F(CheckCommand, RefusesBadTablesInOneLine) {
  const std::string header = "filter,quantity,index,printed\n";
  for (const std::string& table :
       {std::string(), header, std::string("filter,index,printed\nD8,0,1\n"), header + "D9,h,0,1\n",
        header + "D8,x,0,1\n", header + "D8,h,99,1\n", header + "D8,h,0,zero\n",
        header + std::string(1000000, '9') + "\n", std::string("\x89PNG\r\n\x1a\n\0\0\0", 11),
        header + "db2,mu,0,1\n"}) {
    io::write_file(folder_ / "t.csv", table);
    expect_refusal("check t.csv", "t.csv:");
    EXPECT_LT(wavecurve("check t.csv").err.size(), 600U);
  }
}

TEST_F(CheckCommand, RefusesBadUsage) {
  expect_refusal("check", "table");
  expect_refusal("check " + table_1_ + " --format yaml", "yaml");
  expect_refusal("check no/such/table.csv", "no/such/table.csv");
  expect_refusal("check /", "/");
}

}  // namespace
}  // namespace wavecurve::tools
