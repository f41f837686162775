#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wavecurve::io {

/// Writes a document member by member, as json_text() would write it whole, for documents that are
/// written by the million. Doubles have the fewest digits that are read back exactly; what is not
/// finite is null.
class JsonWriter {
 public:
  /// Indented by so many blanks a level, beginning at so many levels; or on one line.
  explicit JsonWriter(int indent = -1, int level = 0) : indent_(indent), level_(level) {}

  void open(char bracket);   ///< '{' or '['
  void close(char bracket);  ///< '}' or ']'
  void key(std::string_view name);
  void value(double number);
  void value(long long number);
  void value(std::string_view text);
  void null();

  template <class T>
  void member(std::string_view name, const T& of) {
    key(name);
    value(of);
  }

  std::string text() && { return std::move(text_); }

 private:
  void begin_item();
  void break_line();

  int indent_, level_;
  bool is_first_ = true, follows_key_ = false;
  std::string text_;
};

}  // namespace wavecurve::io
