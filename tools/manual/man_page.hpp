#pragma once

#include <string>
#include <vector>

#include "tools/manual/command_text.hpp"

namespace wavecurve::tools {

struct ManPage {
  std::string file_name;  ///< "wavecurve-filter.1"
  std::string text;       ///< troff with the macros of man(7)
};

/// A page of the program, and a page of each of its commands, which tells of the commands below it.
/// Without a date, so that two builds write the same bytes.
std::vector<ManPage> man_pages(const CommandText& program, const std::string& version);

}  // namespace wavecurve::tools
