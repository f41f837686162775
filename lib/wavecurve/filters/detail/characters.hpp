#pragma once

#include <string>
#include <string_view>

namespace wavecurve {

// Texts from outside are UTF-8, or should be. What leaves is UTF-8, and holds nothing that a terminal
// or a reader of the format would obey instead of showing it.

/// U+FFFD, in place of what cannot be shown.
inline constexpr std::string_view replacement_character = "\xEF\xBF\xBD";

/// One character of a text in UTF-8, or one byte that is part of none.
struct Character {
  std::string_view bytes;
  char32_t code = 0;  ///< 0xFFFFFFFF: no UTF-8

  bool is_valid() const { return code <= 0x10FFFF; }
  /// Control characters of ASCII and of Unicode: C0, DEL, C1.
  bool is_control() const { return code < 0x20 || (code >= 0x7F && code < 0xA0); }
  /// Valid, and shows in its own place: neither a control character nor a separator of lines or
  /// paragraphs, nor one that turns the direction of the text around it.
  bool shows() const;
};

/// Takes the first character off a text that is not empty. Overlong forms, surrogates and what lies
/// beyond U+10FFFF are no UTF-8.
Character take_character(std::string_view& text);

/// The text as it may stand within a line of any output: each control character, and each byte that is
/// no UTF-8, becomes U+FFFD. A text of more than `most` characters is cut to the
/// first ones and "...".
std::string printable(std::string_view text, std::size_t most = std::string_view::npos);

}  // namespace wavecurve
