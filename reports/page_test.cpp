#include "reports/page.hpp"

#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve::reports {
namespace {

TEST(Page, HasItsSectionsTablesAndCharts) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("wavecurve_page_" + std::to_string(::getpid()));
  verification::Chart chart;
  chart.id = "a-chart";
  chart.data = {"Numbers <of> a chart", {"x", "y"}, {{"1", "2"}, {"2", "3"}}};
  chart.script = "plot data using 1:2 with lines\n";
  const verification::Table table{"A table", {"name", "value"}, {{"one", "1"}}};
  write_page({"A & B", "today", {{"First", {table}}, {"Second", {chart}}}}, folder, "some");

  const std::string html = io::read_file(folder / "some.html");
  for (const char* part : {"<title>A &amp; B</title>", "<a href=\"#part-2\">Second</a>",
                           "id=\"part-2\"", "id=\"table-1\"", "id=\"table-2\"",
                           "href=\"some-figures/a-chart.gp\"", "Numbers &lt;of&gt; a chart"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "some-figures" / "a-chart.dat"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace wavecurve::reports
