#pragma once

#include <string_view>

namespace wavecurve::tools {

// What a person reads in a terminal. Names of files, layers and filters come from outside: no
// character of theirs may act on the terminal or begin a line (characters.hpp).

/// Writes lines of text to the standard output; characters that would act become U+FFFD.
void print_text(std::string_view text);

/// Writes "wavecurve: MESSAGE" to the error stream, as one line; of a long message the beginning and
/// the end. That it cannot be written is ignored: the work goes on.
void print_message(std::string_view message);

}  // namespace wavecurve::tools
