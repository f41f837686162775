#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

namespace wavecurve::tools {

// The one reader for the numbers of the command line. A number is written in decimal, whole and
// finite: "", "nan", "0x10", "12 " and "1e400" are none.

/// A number; none for a text that is not one.
std::optional<double> parsed_number(std::string_view text);

/// A whole number; none for a text that is not one of 64 bits.
std::optional<long> parsed_whole_number(std::string_view text);

/// The check of an option's value: a number from `least` to `most`, of this unit. What is refused is
/// named together with the bounds: "--tolerance: 'nan' is not a number from 0 to 1e+09 (units of
/// the drawing)". Help shows the bounds.
CLI::Validator number_from(double least, double most, const std::string& unit = "");

/// The same for a number above `bound`, which itself is refused.
CLI::Validator number_above(double bound, double most, const std::string& unit = "");

/// The same for a whole number.
CLI::Validator whole_number_from(long least, long most, const std::string& unit = "");

// What the options of several commands may be.

CLI::Validator frames_check();     ///< 2 to 100,000
CLI::Validator samples_check();    ///< 1 to 2^20; that it is a power of two is the library's to say
CLI::Validator levels_check();     ///< 0 to 20
CLI::Validator duration_check();   ///< 0.001 to 86,400 seconds
CLI::Validator tolerance_check();  ///< 0 to 1e9 units of the drawing

/// WIDTHxHEIGHT in pixels, each 2 to 16,384, together at most 2^25; none for another text.
std::optional<std::pair<int, int>> parsed_size(std::string_view text);
CLI::Validator size_check();

/// Their name as validators: every option that takes numbers has one (all_commands_test.cpp).
inline constexpr const char* number_check = "number";

}  // namespace wavecurve::tools
