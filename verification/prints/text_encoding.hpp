#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace wavecurve::verification {

/// The text of a file as UTF-8 without byte order mark. UTF-16 of either byte order, as spreadsheets
/// write it, is told by its byte order mark or by the zero bytes that every second place of it has;
/// all else stays as it is. Throws std::invalid_argument for UTF-32, and for UTF-16 that breaks off
/// within a character.
std::string to_utf8(std::string_view bytes);

/// Every line with its number, counted from 1, without its end: LF, CR LF or CR alone.
void for_each_text_line(std::string_view text,
                        const std::function<void(std::string_view line, int number)>& read);

}  // namespace wavecurve::verification
