#include "reports/html_report.hpp"

#include "reports/escape.hpp"
#include "reports/formula.hpp"
#include "reports/html_evidence.hpp"
#include "reports/html_head.hpp"
#include "reports/verdict_style.hpp"

namespace wavecurve::reports {

namespace {

using namespace verification;

constexpr const char* report_title = "Verification of the published numbers and claims";

std::string header(const Report& report) {
  const Publication& publication = report.publication;
  return "<a class=\"skip\" href=\"#summary\">Skip to the summary</a>\n<header>\n<h1>" +
         std::string(report_title) + "</h1>\n<p class=\"publication\"><cite>" +
         escape(publication.title) + "</cite><br>" + escape(publication.authors) + ". " +
         escape(publication.dates) + ".</p>\n<p class=\"dated\">wavecurve " +
         escape(report.program) + ", generated " + escape(report.generated) +
         "</p>\n<nav aria-label=\"Parts of the report\"><a href=\"#summary\">Summary</a> "
         "<a href=\"#evidence\">Evidence, claim by claim</a> "
         "<a href=\"#verdicts\">What the verdicts mean</a></nav>\n</header>\n";
}

std::string counts_html(const Report& report) {
  std::string html = "<ul class=\"counts\">\n";
  for (const auto& [verdict, count] : count_verdicts(report.results)) {
    html += "<li><strong>" + std::to_string(count) + "</strong> " + badge(verdict) + "</li>\n";
  }
  return html + "</ul>\n";
}

/// On a narrow screen a row becomes a card, and CSS then takes the table's meaning away; the roles
/// keep it for screen readers, the labels show it to the eye.
std::string summary_row(const ClaimResult& result) {
  const auto& [claim, outcome] = result;
  const auto cell = [](const std::string& label, const std::string& html) {
    return "<td role=\"cell\" data-label=\"" + label + "\"><div class=\"clamp\">" + html +
           "</div></td>\n";
  };
  return "<tr role=\"row\">\n<th role=\"rowheader\" scope=\"row\"><a href=\"#claim-" +
         escape(claim.id) + "\">" + formula_html(claim.title) + "</a><span class=\"where\">" +
         escape(claim.location) + "</span></th>\n" + cell("Printed", formula_html(claim.printed)) +
         cell("Own value", formula_html(outcome.finding.sentence)) +
         cell("Verdict", badge(outcome.verdict)) + "</tr>\n";
}

std::string summary(const Report& report) {
  std::string html =
      "<section id=\"summary\" aria-labelledby=\"summary-title\" tabindex=\"-1\">\n"
      "<h2 id=\"summary-title\">Summary</h2>\n" +
      counts_html(report) +
      "<table class=\"summary\" role=\"table\">\n"
      "<caption>Every table, figure and claim tested; each title leads to its evidence</caption>\n"
      "<thead role=\"rowgroup\"><tr role=\"row\">"
      "<th role=\"columnheader\" scope=\"col\">Claim</th>"
      "<th role=\"columnheader\" scope=\"col\">Printed</th>"
      "<th role=\"columnheader\" scope=\"col\">Own value</th>"
      "<th role=\"columnheader\" scope=\"col\">Verdict</th></tr></thead>\n"
      "<tbody role=\"rowgroup\">\n";
  for (const ClaimResult& result : report.results) html += summary_row(result);
  return html + "</tbody>\n</table>\n</section>\n";
}

std::string fact(const std::string& name, const std::string& html) {
  return "<div><dt>" + name + "</dt><dd>" + html + "</dd></div>\n";
}

std::string claim_section(const ClaimResult& result, const Figures& figures) {
  const auto& [claim, outcome] = result;
  const std::string id = escape(claim.id);
  std::string html = "<section class=\"claim\" id=\"claim-" + id + "\" aria-labelledby=\"title-" +
                     id + "\">\n<h3 id=\"title-" + id + "\">" + formula_html(claim.title) +
                     "</h3>\n<p class=\"where\">" + escape(claim.location) + " · <code>" + id +
                     "</code></p>\n<dl>\n" + fact("Printed", formula_html(claim.printed)) +
                     fact("Own value", formula_html(outcome.finding.sentence)) +
                     fact("Verdict", badge(outcome.verdict) + " " + formula_html(outcome.summary)) +
                     "</dl>\n";
  int count = 0;
  for (const Evidence& item : outcome.evidence) {
    html += html_of(item, figures, "table-of-" + id + "-" + std::to_string(++count));
  }
  return html + "<p class=\"back\"><a href=\"#summary\">Back to the summary</a></p>\n</section>\n";
}

/// Every verdict of one kind, up to the last one.
template <class Verdict>
std::string meanings(const std::string& title, Verdict last) {
  std::string html = "<h3>" + title + "</h3>\n<dl class=\"meanings\">\n";
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    const auto verdict = static_cast<Verdict>(i);
    html += fact(badge(verdict), escape(style_of(verdict).meaning));
  }
  return html + "</dl>\n";
}

std::string verdict_list() {
  return "<section id=\"verdicts\" aria-labelledby=\"verdicts-title\">\n"
         "<h2 id=\"verdicts-title\">What the verdicts mean</h2>\n" +
         meanings("A table, figure or statement", ClaimVerdict::stand_in) +
         meanings("A printed number", PrintVerdict::undecided) + "</section>\n";
}

}  // namespace

std::string to_html(const Report& report, const Figures& figures) {
  std::string html = html_head(report_title) + "<body>\n" + header(report) + "<main>\n" +
                     summary(report) +
                     "<section id=\"evidence\" aria-labelledby=\"evidence-title\">\n"
                     "<h2 id=\"evidence-title\">Evidence, claim by claim</h2>\n";
  for (const ClaimResult& result : report.results) html += claim_section(result, figures);
  return html + "</section>\n" + verdict_list() + "</main>\n</body>\n</html>\n";
}

}  // namespace wavecurve::reports
