#include "wavecurve/io/files/detail/json_text.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/filters/detail/characters.hpp"

namespace wavecurve::io {

namespace {

template <class Json>
std::string text_of(const Json& document, int indent) {
  const std::string dumped = document.dump(indent, ' ', false, Json::error_handler_t::replace);
  std::string result;
  result.reserve(dumped.size());
  // The library has escaped the control characters of ASCII but DEL; it and all beyond stand within
  // texts alone.
  const auto is_plain = [](char c) { return static_cast<unsigned char>(c) < 0x7F; };
  for (std::string_view rest = dumped; !rest.empty();) {
    const auto plain =
        static_cast<std::size_t>(std::ranges::find_if_not(rest, is_plain) - rest.begin());
    result += rest.substr(0, plain);
    rest.remove_prefix(plain);
    if (rest.empty()) break;
    const Character character = take_character(rest);
    result += character.shows() ? std::string(character.bytes)
                                : fmt::format("\\u{:04x}", static_cast<unsigned>(character.code));
  }
  return result;
}

}  // namespace

std::string json_text(const nlohmann::json& document, int indent) {
  return text_of(document, indent);
}

std::string json_text(const nlohmann::ordered_json& document, int indent) {
  return text_of(document, indent);
}

std::string quoted(const std::string& text) { return json_text(nlohmann::json(text)); }

}  // namespace wavecurve::io
