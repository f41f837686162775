#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verification/prints/printed_number.hpp"

namespace wavecurve::verification {

/// Numbers in the order in which a text lists them.
struct NumberList {
  std::string name;  ///< the variable or the heading, if there is one
  std::vector<PrintedNumber> numbers;
  std::optional<int> first_index;  ///< if a column of consecutive integers stands beside them
};

/// The lists of numbers of a text in nearly any form: a number a line, separated by commas or
/// blanks, literals of C, Python, MATLAB, R, Julia and Fortran, rows and columns of Markdown and
/// LaTeX, comma-separated tables with or without an index. Words are labels; comments are left out.
///
/// A text with brackets or assignments has a list for each; any other text whose lines have equally
/// many numbers has a list for each column, and a first column of consecutive integers is their
/// index. Decimal commas are understood where no number has a point and no comma is followed by a
/// blank. Throws std::invalid_argument if there is no number, if there are more than
/// most_listed_numbers, or more than longest_list in one list: no known column is nearly so long.
std::vector<NumberList> read_number_lists(std::string_view text);

inline constexpr std::size_t most_listed_numbers = 20'000, longest_list = 500;

}  // namespace wavecurve::verification
