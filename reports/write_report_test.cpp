#include "reports/write_report.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve::reports {
namespace {

namespace fs = std::filesystem;
using namespace verification;

const std::string hostile = "<b>&\"quoted\"'</b>\x01";

Table table_of(std::string caption, int rows) {
  Table table{std::move(caption), {"n", "value", hostile}, {}};
  for (int i = 0; i < rows; ++i) {
    table.rows.push_back({std::to_string(i), std::to_string(i * i) + ".5", "a < b"});
  }
  return table;
}

Report sample_report() {
  const std::string svg =
      "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><defs><path id='gp' d='M0,0'/>"
      "</defs><use href='#gp'/></svg>";
  const Claim first{"table-1", "A <title>", "Section 1", hostile, {}};
  const Claim second{"figure-3", "Another", "Section 2", "15 %", {}};
  Report report{{}, "2026-01-31T12:00:00Z", "1.2.3", {}};
  report.results.push_back(
      {first,
       {ClaimVerdict::certified,
        {hostile, {counted("certified", 24)}},
        "all & sundry",
        {Paragraph{hostile}, table_of("Short", 2), table_of("Long", 40),
         Chart{"first-chart", table_of("Squares", 3), "plot data using 1:2 with lines"},
         Picture{"picture", svg, hostile, table_of("A picture", 2)}}}});
  report.results.push_back(
      {second,
       {ClaimVerdict::does_not_hold,
        {"{}", {to_decimals(hostile, 16, 0, "%")}},
        "",
        {Chart{"second-chart", table_of("Cubes", 3), "plot data using 1:2 with points"}}}});
  return report;
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

/// The values of an attribute, in order.
std::vector<std::string> values_of(const std::string& html, const std::string& attribute) {
  std::vector<std::string> values;
  for (const char quote : {'"', '\''}) {
    const std::string marker = " " + attribute + "=" + quote;
    for (std::size_t at = html.find(marker); at != std::string::npos;
         at = html.find(marker, at + 1)) {
      const std::size_t start = at + marker.size();
      values.push_back(html.substr(start, html.find(quote, start) - start));
    }
  }
  return values;
}

/// The name of the first element that is closed without being open, or left open; empty if none.
std::string unbalanced_element(const std::string& html) {
  static const std::set<std::string> empty_elements = {"meta", "br", "!DOCTYPE"};
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    const std::size_t end = html.find('>', at);
    if (end == std::string::npos) return "an unclosed tag";
    const std::string tag = html.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \t\n/", 1));
    if (tag.back() == '/' || empty_elements.contains(name)) continue;
    if (name[0] != '/' && tag[0] != '/') {
      open.push_back(name);
    } else if (open.empty() || "/" + open.back() != tag) {
      return tag;
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back();
}

class WriteReport : public testing::Test {
 protected:
  void SetUp() override { write_report(sample_report(), directory); }
  void TearDown() override { fs::remove_all(directory); }

  std::string html() const { return io::read_file(directory / "index.html"); }
  nlohmann::json json() const {
    return nlohmann::json::parse(io::read_file(directory / "report.json"));
  }

  const fs::path directory =
      fs::temp_directory_path() / ("wavecurve_report_" + std::to_string(getpid())) / "nested";
};

TEST_F(WriteReport, JsonHoldsEveryClaimWithItsEvidence) {
  const auto document = json();
  EXPECT_EQ(document.at("program"), "1.2.3");
  EXPECT_EQ(document.at("counts").at("certified"), 1);
  EXPECT_EQ(document.at("counts").size(), 2u);
  EXPECT_FALSE(document.at("publication").at("title").get<std::string>().empty());
  const auto& claim = document.at("claims").at(0);
  EXPECT_EQ(claim.at("id"), "table-1");
  EXPECT_EQ(claim.at("printed"), hostile);
  EXPECT_EQ(claim.at("verdict"), "certified");
  EXPECT_EQ(claim.at("evidence").size(), 5u);
  EXPECT_EQ(claim.at("evidence").at(2).at("table").at("rows").size(), 40u);
  EXPECT_EQ(claim.at("evidence").at(3).at("file"), "figures/first-chart.svg");
}

TEST_F(WriteReport, JsonSurvivesBytesThatAreNoText) {
  Report report = sample_report();
  report.results[0].outcome.finding.sentence = "\xff\xfe";
  write_report(report, directory);
  EXPECT_NO_THROW(json());
}

TEST_F(WriteReport, HtmlIsBalancedAndEveryIdIsUnique) {
  EXPECT_EQ(unbalanced_element(html()), "");
  const auto ids = values_of(html(), "id");
  EXPECT_GT(ids.size(), 20u);
  const std::set<std::string> unique(ids.begin(), ids.end());
  for (const std::string& id : unique) EXPECT_EQ(std::ranges::count(ids, id), 1) << id;
}

TEST_F(WriteReport, EveryReferenceWithinThePageHasItsTarget) {
  const auto ids = values_of(html(), "id");
  const std::set<std::string> known(ids.begin(), ids.end());
  for (const std::string& link : values_of(html(), "href")) {
    if (link.starts_with("#")) {
      EXPECT_TRUE(known.contains(link.substr(1))) << link;
    } else {
      EXPECT_TRUE(fs::exists(directory / link)) << link;
    }
  }
  for (const std::string& label : values_of(html(), "aria-labelledby")) {
    EXPECT_TRUE(known.contains(label.substr(0, label.find(' ')))) << label;
  }
}

TEST_F(WriteReport, NothingIsLoadedFromElsewhere) {
  const std::string page = html();
  for (const char* part :
       {"<script", "<link", "<img", "<iframe", "@import", "@font-face", "src="}) {
    EXPECT_EQ(count(page, part), 0) << part;
  }
  // The one kind of address is the name of an XML name space, which nothing fetches.
  EXPECT_EQ(count(page, "http"), count(page, "http://www.w3.org/"));
}

TEST_F(WriteReport, ATableFollowsEachFigure) {
  const std::string page = html();
  EXPECT_EQ(count(page, "<figure "), 3);
  EXPECT_EQ(count(page, "</figure>\n<div class=\"scroll\""), 3);
  EXPECT_EQ(count(page, "role=\"img\""), 3);
  EXPECT_EQ(count(page, "<figcaption>"), 3);
  // Two tables of evidence, three of figures, the summary.
  EXPECT_EQ(count(page, "<table"), 6);
  EXPECT_EQ(count(page, "<caption"), 6);
}

TEST_F(WriteReport, TextIsEscaped) {
  const std::string page = html();
  EXPECT_EQ(count(page, "<b>"), 0);
  EXPECT_EQ(count(page, "\x01"), 0);
  EXPECT_GT(count(page, "&lt;b&gt;&amp;&quot;quoted&quot;&#39;&lt;/b&gt;\xEF\xBF\xBD"), 5);
  EXPECT_EQ(count(page, "A &lt;title&gt;"), 2);
}

TEST_F(WriteReport, EachVerdictIsAWordAndASymbol) {
  EXPECT_GE(count(html(), "<span aria-hidden=\"true\">✓</span> certified</span>"), 3);
  EXPECT_GE(count(html(), "<span aria-hidden=\"true\">✗</span> does-not-hold</span>"), 3);
}

TEST_F(WriteReport, OnlyTheDatedLineDiffersBetweenTwoRuns) {
  const std::string first_html = html(), first_json = io::read_file(directory / "report.json");
  Report later = sample_report();
  later.generated = "2027-07-07T07:07:07Z";
  write_report(later, directory);
  const auto dated = [&](std::string text) {
    EXPECT_EQ(count(text, later.generated), 1);
    return text.replace(text.find(later.generated), later.generated.size(), "2026-01-31T12:00:00Z");
  };
  EXPECT_EQ(dated(html()), first_html);
  EXPECT_EQ(dated(io::read_file(directory / "report.json")), first_json);
}

TEST_F(WriteReport, RefusesFiguresWithOneIdOrAnIdThatIsAPath) {
  Report report = sample_report();
  report.results.push_back(report.results.front());
  EXPECT_THROW(write_report(report, directory), std::logic_error);
  report.results = {{{}, {ClaimVerdict::holds, {}, "", {Picture{"../up", "<svg></svg>", "", {}}}}}};
  EXPECT_THROW(write_report(report, directory), std::logic_error);
}

TEST(DateOfReport, HonoursSourceDateEpoch) {
  setenv("SOURCE_DATE_EPOCH", "86400", 1);
  EXPECT_EQ(date_of_report(), "1970-01-02T00:00:00Z");
  for (const char* wrong : {"", "soon", "12x", "-1", "99999999999999999999"}) {
    setenv("SOURCE_DATE_EPOCH", wrong, 1);
    EXPECT_THROW(date_of_report(), std::invalid_argument) << wrong;
  }
  unsetenv("SOURCE_DATE_EPOCH");
  EXPECT_GT(date_of_report(), "2024-01-01");
}

}  // namespace
}  // namespace wavecurve::reports
