#include "wavecurve/io/files/detail/xml_escaped.hpp"

#include "wavecurve/filters/detail/characters.hpp"

namespace wavecurve::io {

namespace {

/// What XML has for a character; itself, where that may stand.
std::string_view escaped_form(const Character& character) {
  switch (character.code) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    case '\t':
    case '\n':
      return character.bytes;
    // Control characters, and the two that are reserved as none.
    case 0xFFFE:
    case 0xFFFF:
      return replacement_character;
    default:
      return character.is_valid() && !character.is_control() ? character.bytes
                                                             : replacement_character;
  }
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  while (!text.empty()) escaped += escaped_form(take_character(text));
  return escaped;
}

}  // namespace wavecurve::io
