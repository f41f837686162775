#include "tools/commands/output/check_page.hpp"

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "reports/escape.hpp"
#include "reports/html_head.hpp"
#include "reports/verdict_style.hpp"
#include "tools/commands/output/check_sentences.hpp"
#include "verification/prints/marked_print.hpp"

namespace wavecurve::tools {

namespace {

using namespace wavecurve::verification;
using reports::badge;
using reports::escape;

/// Shows the rows whose verdict is ticked, and says how many they are.
constexpr std::string_view script = R"(<script>
(() => {
  const filter = document.getElementById("filter");
  const boxes = [...filter.querySelectorAll("input")];
  const rows = [...document.querySelectorAll("tr[data-verdict]")];
  const update = () => {
    const chosen = new Set(boxes.filter(box => box.checked).map(box => box.value));
    let shown = 0;
    for (const row of rows) {
      row.hidden = !chosen.has(row.dataset.verdict);
      if (!row.hidden) ++shown;
    }
    document.getElementById("shown").textContent =
      shown === rows.length ? "" : `; ${shown} of ${rows.length} rows shown`;
  };
  filter.addEventListener("change", update);
  filter.disabled = false;
  update();
})();
</script>
)";

std::string cell(const std::string& html, std::string_view kind = "") {
  return kind.empty() ? "<td>" + html + "</td>"
                      : fmt::format("<td class=\"{}\">{}</td>", kind, html);
}

std::string printed_html(const CheckedRow& row) {
  std::string html;
  for (const auto& [text, departs] :
       marked_print(row.entry.printed, row.entry.number, row.departure)) {
    if (!departs) {
      html += escape(text);
    } else if (text.empty()) {
      html += "<mark title=\"a sign is missing\">&nbsp;</mark>";
    } else {
      html += "<mark>" + escape(text) + "</mark>";
    }
  }
  return "<code>" + html + "</code>";
}

std::string row_html(const CheckedRow& row) {
  std::string html =
      fmt::format("<tr data-verdict=\"{}\"><th scope=\"row\">{}</th>", to_string(row.verdict),
                  escape(row.entry.filter)) +
      cell(escape(to_string(row.entry.quantity))) + cell(escape(row.entry.index.text()), "number") +
      cell(printed_html(row), "print") +
      cell("<code>" + escape(row.certified) + "</code>", "print") +
      cell(ulps_text(row.ulps, 3), "number") + cell(badge(row.verdict)) + cell(escape(row.detail));
  for (const std::string& field : row.entry.extra) html += cell(escape(field));
  return html + "</tr>\n";
}

/// The counts, which are the filter as well. A form that nothing reads yet is disabled.
std::string counts_html(const CheckedTable& table) {
  std::string html =
      "<fieldset id=\"filter\" disabled>\n<legend>Verdicts, and which rows are shown</legend>\n"
      "<ul class=\"counts\">\n";
  for (const auto& [verdict, count] : table.counts()) {
    html += fmt::format(
        "<li><label><input type=\"checkbox\" value=\"{}\" checked autocomplete=\"off\"> "
        "<strong>{}</strong> {}</label></li>\n",
        to_string(verdict), count, badge(verdict));
  }
  return html + "</ul>\n</fieldset>\n";
}

std::string rows_html(const CheckedTable& table) {
  std::string html =
      "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-labelledby=\"rows\">\n<table class=\"checked\">\n"
      "<caption id=\"rows\">Printed numbers beside the certified ones; marked is what departs from "
      "the true value; distances are in units of the print's last digit<span id=\"shown\" "
      "role=\"status\"></span></caption>\n<thead><tr>";
  for (const char* name : {"Filter", "Quantity"}) {
    html += fmt::format("<th scope=\"col\">{}</th>", name);
  }
  html +=
      "<th scope=\"col\" class=\"number\">Index</th><th scope=\"col\">Printed</th>"
      "<th scope=\"col\">Certified</th><th scope=\"col\" class=\"number\">Distance</th>"
      "<th scope=\"col\">Verdict</th><th scope=\"col\">Detail</th>";
  for (const std::string& name : table.extra_columns) {
    html += "<th scope=\"col\">" + escape(name) + "</th>";
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const CheckedRow& row : table.rows) html += row_html(row);
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string section(const std::string& title, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string html = "<section>\n<h2>" + title + "</h2>\n<ul class=\"sentences\">\n";
  for (const std::string& sentence : sentences) html += "<li>" + escape(sentence) + "</li>\n";
  return html + "</ul>\n</section>\n";
}

std::string meanings(const CheckedTable& table) {
  std::string html = "<section>\n<h2>What the verdicts mean</h2>\n<dl class=\"meanings\">\n";
  for (const auto& [verdict, count] : table.counts()) {
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", badge(verdict),
                        escape(reports::style_of(verdict).meaning));
  }
  return html + "</dl>\n</section>\n";
}

}  // namespace

std::string check_as_page(const CheckedTable& table) {
  const std::string title = table.title.empty() ? "A published table, checked" : table.title;
  return reports::html_head(title) + "<body>\n<header>\n<h1>" + escape(title) +
         "</h1>\n<p class=\"dated\">" + escape(table.file) +
         ", held against certified values by "
         "wavecurve " WAVECURVE_VERSION "</p>\n</header>\n<main>\n" +
         counts_html(table) + rows_html(table) +
         section("Conventions", convention_sentences(table)) +
         section("What columns have in common", habit_sentences(table)) +
         section("Where the numbers come from, column by column", route_sentences(table)) +
         meanings(table) + "</main>\n" + std::string(script) + "</body>\n</html>\n";
}

}  // namespace wavecurve::tools
