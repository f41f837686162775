#pragma once

#include <functional>
#include <string_view>

namespace wavecurve::io {

/// The lines of a text, counted from 1, without what follows a # and without white space at either
/// end; lines of which nothing is left are passed over. A byte order mark is, too.
void for_each_line(std::string_view text,
                   const std::function<void(std::string_view line, int number)>& read);

}  // namespace wavecurve::io
