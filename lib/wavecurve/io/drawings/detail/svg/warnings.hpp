#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace wavecurve::io {

/// What a reader had to leave out, each once, in the order of appearance: of every kind the first
/// few, and in the end how many more there are. A kind is what one form of words is made for.
class Warnings {
 public:
  static constexpr std::size_t most_of_a_kind = 20;

  template <typename... Values>
  void add(fmt::format_string<Values...> form, Values&&... values) {
    const fmt::string_view words = form;
    add_once({words.data(), words.size()}, fmt::format(form, std::forward<Values>(values)...));
  }

  std::vector<std::string> list() const {
    std::vector<std::string> lines = first_;
    for (const auto& [form, kind] : kinds_) {
      if (kind.all.size() <= most_of_a_kind) continue;
      lines.push_back(
          fmt::format("{} more like \"{}\"", kind.all.size() - most_of_a_kind, kind.last));
    }
    return lines;
  }

 private:
  struct Kind {
    std::unordered_set<std::string> all;
    std::string last;  ///< of the first few
  };

  void add_once(std::string_view form, const std::string& text) {
    Kind& kind = kinds_[form];
    if (!kind.all.insert(text).second || kind.all.size() > most_of_a_kind) return;
    kind.last = text;
    first_.push_back(text);
  }

  std::vector<std::string> first_;
  std::map<std::string_view, Kind> kinds_;  ///< by the form, which is a constant of the program
};

}  // namespace wavecurve::io
