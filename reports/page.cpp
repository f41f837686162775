#include "reports/page.hpp"

#include <map>
#include <variant>

#include <fmt/format.h>

#include "wavecurve/io/files/write_file.hpp"

#include "reports/escape.hpp"
#include "reports/figure_writer.hpp"
#include "reports/formula.hpp"
#include "reports/html_evidence.hpp"
#include "reports/html_head.hpp"

namespace wavecurve::reports {

namespace {

std::string opening(const Page& page) {
  return html_head(page.title) + "<body>\n<header>\n<h1>" + escape(page.title) +
         "</h1>\n<p class=\"dated\">" + escape(page.generated) + "</p>\n";
}

std::string contents(const Page& page) {
  std::string html = "<nav aria-label=\"Parts of the page\">";
  for (std::size_t i = 0; i < page.sections.size(); ++i) {
    html += fmt::format("<a href=\"#part-{}\">{}</a> ", i + 1, escape(page.sections[i].title));
  }
  return html + "</nav>\n</header>\n";
}

}  // namespace

void write_page(const Page& page, const std::filesystem::path& directory, const std::string& name) {
  const std::string folder = name + "-figures";
  FigureWriter figures{directory / folder};
  std::filesystem::create_directories(figures.directory);
  std::string html = opening(page) + contents(page) + "<main>\n";
  int tables = 0;
  for (std::size_t i = 0; i < page.sections.size(); ++i) {
    const Section& section = page.sections[i];
    html += fmt::format(
        "<section id=\"part-{0}\" aria-labelledby=\"title-{0}\">\n"
        "<h2 id=\"title-{0}\">{1}</h2>\n",
        i + 1, formula_html(section.title));
    for (const verification::Evidence& item : section.evidence) {
      std::visit(figures, item);
      html += html_of(item, figures.svgs, fmt::format("table-{}", ++tables), folder);
    }
    html += "</section>\n";
  }
  io::write_file(directory / (name + ".html"), html + "</main>\n</body>\n</html>\n");
}

}  // namespace wavecurve::reports
