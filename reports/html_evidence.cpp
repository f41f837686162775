#include "reports/html_evidence.hpp"

#include <cctype>
#include <cstdlib>

#include "reports/escape.hpp"
#include "reports/formula.hpp"
#include "reports/inline_svg.hpp"

namespace wavecurve::reports {

namespace {

using namespace verification;

/// A longer table scrolls within its own box on the screen; on paper it is printed whole.
constexpr std::size_t rows_of_a_long_table = 16;

bool is_number(const std::string& cell) {
  char* end = nullptr;
  std::strtod(cell.c_str(), &end);
  return !cell.empty() && std::isspace(static_cast<unsigned char>(cell.front())) == 0 &&
         *end == '\0';
}

std::string cell_html(const std::string& cell, bool is_row_header) {
  const std::string name = is_row_header ? "th scope=\"row\"" : "td";
  return "<" + name + (is_number(cell) ? " class=\"number\">" : ">") + formula_html(cell) +
         (is_row_header ? "</th>" : "</td>");
}

std::string row_html(const std::vector<std::string>& row) {
  std::string html = "<tr>";
  bool is_first = true;
  for (const std::string& cell : row) {
    html += cell_html(cell, is_first);
    is_first = false;
  }
  return html + "</tr>\n";
}

/// A column whose cells are numbers is headed flush right, as they are.
bool is_number_column(const Table& table, std::size_t column) {
  for (const auto& row : table.rows) {
    if (column < row.size() && is_number(row[column])) return true;
  }
  return false;
}

std::string head_html(const Table& table) {
  std::string html = "<thead><tr>";
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    html +=
        is_number_column(table, i) ? "<th scope=\"col\" class=\"number\">" : "<th scope=\"col\">";
    html += formula_html(table.columns[i]) + "</th>";
  }
  return html + "</tr></thead>\n";
}

std::string table_html(const Table& table, const std::string& id) {
  const bool is_long = table.rows.size() > rows_of_a_long_table;
  // A region that scrolls must be reachable by keyboard, and then needs a name.
  std::string html = "<div class=\"scroll" + std::string(is_long ? " long" : "") +
                     "\" role=\"region\" tabindex=\"0\" aria-labelledby=\"" + id +
                     "\">\n<table>\n" + "<caption id=\"" + id + "\">" +
                     formula_html(table.caption) + "</caption>\n" + head_html(table) + "<tbody>\n";
  for (const auto& row : table.rows) html += row_html(row);
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string figure_html(const std::string& id, const std::string& svg, const Table& data,
                        const std::string& description, const std::string& note,
                        const std::string& table_id) {
  Table numbers = data;
  numbers.caption = "The numbers shown: " + data.caption;
  return "<figure id=\"figure-" + id + "\">\n" +
         inline_svg(svg, "svg-" + id + "-", data.caption, description) + "\n<figcaption>" +
         formula_html(data.caption) + note + "</figcaption>\n</figure>\n" +
         table_html(numbers, table_id);
}

struct EvidenceToHtml {
  const Figures& figures;
  const std::string& table_id;
  const std::string& folder;

  std::string operator()(const Paragraph& paragraph) const {
    return "<p>" + formula_html(paragraph.text) + "</p>\n";
  }
  std::string operator()(const Table& table) const { return table_html(table, table_id); }
  std::string operator()(const Chart& chart) const {
    const std::string base = escape(folder) + "/" + escape(chart.id);
    const std::string note = " <span class=\"files\">Drawn by gnuplot: <a href=\"" + base +
                             ".gp\">script</a>, <a href=\"" + base + ".dat\">data</a>.</span>";
    return figure_html(chart.id, figures.at(chart.id), chart.data,
                       "A chart; its numbers are in the table that follows.", note, table_id);
  }
  std::string operator()(const Picture& picture) const {
    return figure_html(picture.id, figures.at(picture.id), picture.data, picture.alternative_text,
                       "", table_id);
  }
};

}  // namespace

std::string html_of(const Evidence& evidence, const Figures& figures, const std::string& table_id,
                    const std::string& folder) {
  return std::visit(EvidenceToHtml{figures, table_id, folder}, evidence);
}

}  // namespace wavecurve::reports
