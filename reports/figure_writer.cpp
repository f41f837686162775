#include "reports/figure_writer.hpp"

#include <algorithm>
#include <stdexcept>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "reports/gnuplot.hpp"

namespace wavecurve::reports {

namespace {

bool fits_a_file_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
}

}  // namespace

void FigureWriter::operator()(const verification::Chart& chart) {
  claim_id(chart.id);
  draw_chart(chart, directory);
  svgs[chart.id] = io::read_file(directory / (chart.id + ".svg"));
}

void FigureWriter::operator()(const verification::Picture& picture) {
  claim_id(picture.id);
  io::write_file(directory / (picture.id + ".svg"), picture.svg);
  svgs[picture.id] = picture.svg;
}

void FigureWriter::claim_id(const std::string& id) const {
  if (id.empty() || !std::ranges::all_of(id, fits_a_file_name)) {
    throw std::logic_error("a figure has the id \"" + id + "\"; only a-z, 0-9 and - are allowed");
  }
  if (svgs.contains(id)) throw std::logic_error("two figures have the id " + id);
}

}  // namespace wavecurve::reports
