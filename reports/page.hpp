#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/suite/claim.hpp"

namespace wavecurve::reports {

/// A page beside the report, of the same form: sections of evidence.
struct Section {
  std::string title;
  std::vector<verification::Evidence> evidence;
};
struct Page {
  std::string title;
  std::string generated;  ///< when, and on what
  std::vector<Section> sections;
};

/// Writes NAME.html and, below NAME-figures/, what its charts are drawn from.
/// Throws as write_report does.
void write_page(const Page& page, const std::filesystem::path& directory, const std::string& name);

}  // namespace wavecurve::reports
