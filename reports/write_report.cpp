#include "reports/write_report.hpp"

#include <variant>

#include "wavecurve/io/files/write_file.hpp"

#include "reports/figure_writer.hpp"
#include "reports/html_report.hpp"
#include "reports/json_report.hpp"

namespace wavecurve::reports {

void write_report(const Report& report, const std::filesystem::path& directory) {
  FigureWriter figures{directory / "figures"};
  std::filesystem::create_directories(figures.directory);
  for (const verification::ClaimResult& result : report.results) {
    for (const verification::Evidence& item : result.outcome.evidence) std::visit(figures, item);
  }
  io::write_file(directory / "report.json", to_json(report));
  io::write_file(directory / "index.html", to_html(report, figures.svgs));
}

}  // namespace wavecurve::reports
