#include "wavecurve/filters/detail/characters.hpp"

#include <algorithm>

namespace wavecurve {

namespace {

constexpr char32_t no_character = 0xFFFFFFFF;

/// The bytes of a character that begins so, and the smallest code that needs so many; 0 for a byte
/// that begins none.
struct Form {
  std::size_t bytes;
  char32_t bits, least;
};

Form form_of(unsigned char first) {
  if (first < 0x80) return {1, first, 0};
  if (first >= 0xC0 && first < 0xE0) return {2, first & 0x1FU, 0x80};
  if (first >= 0xE0 && first < 0xF0) return {3, first & 0x0FU, 0x800};
  if (first >= 0xF0 && first < 0xF8) return {4, first & 0x07U, 0x10000};
  return {0, 0, 0};
}

/// The code of the bytes as a whole.
char32_t code_of(std::string_view bytes, const Form& form) {
  char32_t code = form.bits;
  for (const char byte : bytes.substr(1)) {
    if ((static_cast<unsigned char>(byte) & 0xC0U) != 0x80U) return no_character;
    code = code << 6 | (static_cast<unsigned char>(byte) & 0x3FU);
  }
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  return code < form.least || code > 0x10FFFF || is_surrogate ? no_character : code;
}

}  // namespace

bool Character::shows() const {
  const bool is_mark = code == 0x061C || code == 0x200E || code == 0x200F;
  // Separators, embeddings and overrides; isolates.
  const bool is_format = (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  return is_valid() && !is_control() && !is_mark && !is_format;
}

Character take_character(std::string_view& text) {
  const Form form = form_of(static_cast<unsigned char>(text.front()));
  Character character{text.substr(0, 1), no_character};
  if (form.bytes > 0 && form.bytes <= text.size()) {
    const std::string_view bytes = text.substr(0, form.bytes);
    const char32_t code = code_of(bytes, form);
    if (code != no_character) character = {bytes, code};
  }
  text.remove_prefix(character.bytes.size());
  return character;
}

std::string printable(std::string_view text, std::size_t most) {
  std::string result;
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count == most) return result + "...";
    const Character character = take_character(text);
    result += character.shows() ? character.bytes : replacement_character;
  }
  return result;
}

}  // namespace wavecurve
