#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/checker/check_table.hpp"

namespace wavecurve::verification {

/// What is said of one of the tables that people copy.
struct AtlasEntry {
  std::string file, title, source;
  int numbers = 0;
  int right = 0;  ///< certified, or right but for the form
  int wrong = 0;
  /// Significant digits, of the largest entry of its column, in which the worst entry is right; as
  /// many as are printed if nothing is wrong.
  int right_digits = 0;
  /// What made it: conventions, routes, misprints, other solutions; one sentence each.
  std::vector<std::string> causes;
};

AtlasEntry atlas_entry(const CheckedTable& table);

/// Every table (.csv) of a folder, by file name. Adding a table adds a file, and no line here.
/// Throws as read_published_table and check_table.
std::vector<AtlasEntry> judge_atlas(const std::filesystem::path& folder);

/// The atlas as a page: which tables are right, which are not, from which digit, and why.
std::string atlas_page(const std::vector<AtlasEntry>& entries);

}  // namespace wavecurve::verification
