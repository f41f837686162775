#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "wavecurve/certified/decimal_enclosure.hpp"

namespace wavecurve::tools {

// What the commands that print certified numbers share.

/// `--digits N`: significant digits, 1 .. 1000.
void add_digits_option(CLI::App& command, int& digits);

/// `--format F`, one of the given.
void add_format_option(CLI::App& command, std::string& format, std::vector<std::string> accepted);

/// "every value is within 5e-41 of the true one": by the largest of the radii.
std::string accuracy_text(const std::vector<certified::DecimalEnclosure>& values);

/// A C++ header's first lines, an array of doubles, its last lines. The namespace is made from the
/// filter's name: wavecurve_tables::bspline4_4.
std::string header_opening(const std::string& title, const std::string& filter_name);
std::string header_array(const std::string& name, const std::vector<std::string>& decimals);
std::string header_closing(const std::string& filter_name);

}  // namespace wavecurve::tools
