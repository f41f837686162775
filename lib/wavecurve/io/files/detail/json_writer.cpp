#include "wavecurve/io/files/detail/json_writer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/json_text.hpp"

namespace wavecurve::io {

void JsonWriter::break_line() {
  if (indent_ < 0) return;
  text_ += '\n';
  text_.append(static_cast<std::size_t>(indent_ * level_), ' ');
}

void JsonWriter::begin_item() {
  if (follows_key_) {
    follows_key_ = false;
    return;
  }
  if (text_.empty()) return;  // the document itself
  if (!is_first_) text_ += ',';
  break_line();
  is_first_ = false;
}

void JsonWriter::open(char bracket) {
  begin_item();
  text_ += bracket;
  ++level_;
  is_first_ = true;
}

void JsonWriter::close(char bracket) {
  --level_;
  if (!is_first_) break_line();
  text_ += bracket;
  is_first_ = false;
}

void JsonWriter::key(std::string_view name) {
  value(name);
  text_ += indent_ < 0 ? ":" : ": ";
  follows_key_ = true;
}

void JsonWriter::value(double number) {
  if (!std::isfinite(number)) return null();
  begin_item();
  const std::size_t before = text_.size();
  fmt::format_to(std::back_inserter(text_), "{}", number);
  const std::string_view written = std::string_view(text_).substr(before);
  if (written.find_first_of(".e") == std::string_view::npos) text_ += ".0";
}

void JsonWriter::value(long long number) {
  begin_item();
  fmt::format_to(std::back_inserter(text_), "{}", number);
}

void JsonWriter::value(std::string_view text) {
  begin_item();
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
  if (!std::ranges::all_of(text, is_plain)) {
    text_ += quoted(std::string(text));
    return;
  }
  text_ += '"';
  text_ += text;
  text_ += '"';
}

void JsonWriter::null() {
  begin_item();
  text_ += "null";
}

}  // namespace wavecurve::io
