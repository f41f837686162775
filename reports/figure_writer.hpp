#pragma once

#include <filesystem>
#include <string>

#include "reports/figures.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::reports {

/// Draws charts and copies pictures into a directory, and keeps each one's SVG document by its id.
/// A visitor of Evidence. Throws std::logic_error for an id that is no file name or is used twice,
/// and what draw_chart and io::write_file throw.
struct FigureWriter {
  std::filesystem::path directory;
  Figures svgs = {};

  void operator()(const verification::Paragraph&) {}
  void operator()(const verification::Table&) {}
  void operator()(const verification::Chart& chart);
  void operator()(const verification::Picture& picture);

 private:
  void claim_id(const std::string& id) const;
};

}  // namespace wavecurve::reports
