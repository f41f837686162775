#include "wavecurve/io/drawings/detail/svg/xml_entities.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

constexpr std::string_view blanks = " \t\r\n";

bool is_predefined(std::string_view name) {
  return name == "lt" || name == "gt" || name == "amp" || name == "quot" || name == "apos";
}

/// Copies a document, entity by entity.
class EntityReader {
 public:
  explicit EntityReader(std::string_view bytes) : bytes_(bytes) {}

  std::string expanded() {
    while (at_ < bytes_.size()) copy_next();
    return std::move(result_);
  }

 private:
  [[noreturn]] void refuse(const std::string& defect) const {
    const auto line =
        1 + std::count(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    throw std::invalid_argument(fmt::format("line {}: {}", line, defect));
  }

  std::string_view rest() const { return bytes_.substr(at_); }

  /// Copies up to the end of what is read as it stands.
  void copy_through(std::string_view end) {
    const std::size_t found = bytes_.find(end, at_);
    const std::size_t stop = found == std::string_view::npos ? bytes_.size() : found + end.size();
    result_ += bytes_.substr(at_, stop - at_);
    at_ = stop;
  }

  void copy_next() {
    if (quote_ == 0 && rest().starts_with("<!--")) return copy_through("-->");
    if (quote_ == 0 && rest().starts_with("<![CDATA[")) return copy_through("]]>");
    if (quote_ == 0 && rest().starts_with("<?")) return copy_through("?>");
    if (quote_ == 0 && rest().starts_with("<!ENTITY")) return declare();
    const char c = bytes_[at_];
    if (c == '&') return copy_reference();
    if (quote_ != 0) {
      if (c == quote_) quote_ = 0;
    } else if (c == '<') {
      in_tag_ = true;
    } else if (c == '>') {
      in_tag_ = false;
    } else if (in_tag_ && (c == '"' || c == '\'')) {
      quote_ = c;
    }
    result_ += c;
    ++at_;
  }

  /// Reads a declaration, of which only the line breaks are left.
  void declare() {
    const std::size_t begin = at_;
    std::string_view text = rest().substr(8);
    const auto skip_blanks = [&] {
      text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    };
    skip_blanks();
    if (text.starts_with('%')) {
      refuse(fmt::format("declares the parameter entity {}; only general ones are read",
                         shown(trimmed(text.substr(1, text.find_first_of("\"'>") - 1)))));
    }
    const std::string name(text.substr(0, text.find_first_of(" \t\r\n\"'>")));
    text.remove_prefix(name.size());
    skip_blanks();
    if (text.starts_with("SYSTEM") || text.starts_with("PUBLIC")) {
      refuse(
          fmt::format("declares the entity {}, which lies elsewhere and is not read", shown(name)));
    }
    const std::size_t end = text.empty() ? std::string_view::npos : text.find(text[0], 1);
    if ((!text.starts_with('"') && !text.starts_with('\'')) || end == std::string_view::npos) {
      refuse(fmt::format("the entity {} has no value in quotes", shown(name)));
    }
    const std::string_view value = text.substr(1, end - 1);
    text.remove_prefix(end + 1);
    skip_blanks();
    if (!text.starts_with('>'))
      refuse(fmt::format("the entity {} does not end with >", shown(name)));
    if (entities_.size() == most_entities)
      refuse(fmt::format("more than {} entities", most_entities));
    entities_.emplace(name, value);  // of several the first is meant
    at_ = bytes_.size() - text.size() + 1;
    for (const char c : bytes_.substr(begin, at_ - begin)) {
      if (c == '\n') result_ += c;
    }
  }

  void count(std::size_t characters) {
    count_ += characters;
    if (count_ > most_expanded) {
      refuse(
          fmt::format("entities stand for more than {} references and characters", most_expanded));
    }
  }

  /// The name of the reference at the begin of a text, if it is one to a declared entity. Names are not so
  /// long that a text full of & would be searched through for the end of each.
  std::string_view referred(std::string_view text) const {
    constexpr std::size_t longest_name = 256;
    const std::size_t end = text.substr(0, longest_name + 2).find(';');
    if (end == std::string_view::npos) return {};
    const std::string_view name = text.substr(1, end - 1);
    return is_predefined(name) || !entities_.contains(name) ? std::string_view() : name;
  }

  void copy_reference() {
    const std::string_view name = referred(rest());
    if (name.empty()) {
      result_ += '&';
      ++at_;
      return;
    }
    put(name, 1);
    at_ += name.size() + 2;
  }

  void put(std::string_view name, std::size_t depth) {
    if (depth > deepest_entity) {
      refuse(fmt::format("the entity {} lies in itself, or in more than {} others", shown(name),
                         deepest_entity));
    }
    count(1);
    std::string_view value = entities_.find(name)->second;
    while (!value.empty()) {
      const std::string_view inner = value[0] == '&' ? referred(value) : std::string_view();
      if (!inner.empty()) {
        put(inner, depth + 1);
        value.remove_prefix(inner.size() + 2);
        continue;
      }
      // A reference to & is read when the entity is declared, so that what follows may be a reference.
      const bool ampersand = value.starts_with("&#38;");
      put_character(ampersand ? '&' : value[0]);
      value.remove_prefix(ampersand ? 5 : 1);
    }
  }

  /// In the value of an attribute quotes are part of the value.
  void put_character(char c) {
    count(1);
    if (quote_ != 0 && c == '"') {
      result_ += "&quot;";
    } else if (quote_ != 0 && c == '\'') {
      result_ += "&apos;";
    } else {
      result_ += c == '\n' || c == '\r' ? ' ' : c;
    }
  }

  std::string_view bytes_;
  std::size_t at_ = 0, count_ = 0;
  std::string result_;
  std::map<std::string, std::string_view, std::less<>> entities_;
  bool in_tag_ = false;
  char quote_ = 0;  ///< the one in which a value stands
};

}  // namespace

std::string with_entities(std::string_view bytes) { return EntityReader(bytes).expanded(); }

}  // namespace wavecurve::io
