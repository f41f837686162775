#include "write_report.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <variant>

#include "wavecurve/io/read_file.hpp"
#include "wavecurve/io/write_file.hpp"

#include "gnuplot.hpp"
#include "html_report.hpp"
#include "json_report.hpp"

namespace wavecurve::reports {

namespace {

namespace fs = std::filesystem;
using namespace verification;

bool fits_a_file_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
}

/// Draws or copies figures into the directory and keeps each one's SVG.
struct FigureWriter {
  fs::path directory;
  std::map<std::string, std::string> svgs;

  void operator()(const Paragraph&) {}
  void operator()(const Table&) {}
  void operator()(const Chart& chart) {
    claim_id(chart.id);
    draw_chart(chart, directory);
    svgs[chart.id] = io::read_file(directory / (chart.id + ".svg"));
  }
  void operator()(const Picture& picture) {
    claim_id(picture.id);
    io::write_file(directory / (picture.id + ".svg"), picture.svg);
    svgs[picture.id] = picture.svg;
  }

  void claim_id(const std::string& id) const {
    if (id.empty() || !std::ranges::all_of(id, fits_a_file_name)) {
      throw std::logic_error("a figure has the id \"" + id + "\"; only a-z, 0-9 and - are allowed");
    }
    if (svgs.contains(id)) throw std::logic_error("two figures have the id " + id);
  }
};

}  // namespace

void write_report(const Report& report, const fs::path& directory) {
  FigureWriter figures{directory / "figures", {}};
  fs::create_directories(figures.directory);
  for (const ClaimResult& result : report.results) {
    for (const Evidence& item : result.outcome.evidence) std::visit(figures, item);
  }
  io::write_file(directory / "report.json", to_json(report));
  io::write_file(directory / "index.html", to_html(report, figures.svgs));
}

}  // namespace wavecurve::reports
