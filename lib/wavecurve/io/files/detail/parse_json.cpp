#include "wavecurve/io/files/detail/parse_json.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve::io {

namespace {

/// Builds a document from the events of the parser, which has no recursion.
template <class Json>
class Builder : public nlohmann::json_sax<Json> {
 public:
  Builder(const std::string& text, JsonNumbers numbers) : text_(text), numbers_(numbers) {}

  Json document() { return std::move(root_); }

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(typename Json::number_integer_t value) override { return put(value); }
  bool number_unsigned(typename Json::number_unsigned_t value) override { return put(value); }
  bool number_float(typename Json::number_float_t value, const std::string& written) override {
    return numbers_ == JsonNumbers::doubles ? put(value) : put(written);
  }
  bool string(std::string& value) override { return put(std::move(value)); }
  bool binary(typename Json::binary_t& /*value*/) override { return false; }

  bool start_object(std::size_t /*size*/) override { return open(Json::object()); }
  bool start_array(std::size_t /*size*/) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(std::string& name) override {
    if (open_.back()->contains(name)) {
      throw std::invalid_argument("key " + value_text(std::string_view(name)) + " stands twice");
    }
    key_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::detail::exception& error) override {
    constexpr int out_of_range = 406;
    constexpr std::string_view line_break = "<U+000A>";  // as the parser writes it
    std::string_view token = last_token;
    if (const auto at = token.rfind(line_break); at != token.npos) {
      token.remove_prefix(at + line_break.size());
    }
    token.remove_prefix(std::min(token.find_first_not_of(' '), token.size()));
    const std::string_view before =
        std::string_view(text_).substr(0, position > 0 ? position - 1 : 0);
    const auto line = 1 + std::ranges::count(before, '\n');
    const auto column = before.size() - (before.rfind('\n') + 1) + 1;
    throw std::invalid_argument(
        fmt::format("not JSON: line {}, column {}: {} {}", line, column, value_text(token),
                    error.id == out_of_range ? "is too large a number" : "is not expected"));
  }

 private:
  bool put(Json value) {
    add(std::move(value));
    return true;
  }

  Json& add(Json value) {
    if (open_.empty()) return root_ = std::move(value);
    Json& parent = *open_.back();
    if (parent.is_object()) return parent[key_] = std::move(value);
    parent.push_back(std::move(value));
    return parent.back();
  }

  bool open(Json container) {
    if (open_.size() == deepest_json) {
      throw std::invalid_argument(
          fmt::format("the document is nested more than {} deep", deepest_json));
    }
    open_.push_back(&add(std::move(container)));
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  const std::string& text_;
  JsonNumbers numbers_;
  Json root_;
  std::vector<Json*> open_;
  std::string key_;
};

template <class Json>
Json parsed(const std::string& text, JsonNumbers numbers) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw std::invalid_argument("not JSON: it is empty");
  }
  Builder<Json> builder(text, numbers);
  Json::sax_parse(text, &builder);
  return builder.document();
}

}  // namespace

nlohmann::json parse_json(const std::string& text, JsonNumbers numbers) {
  return parsed<nlohmann::json>(text, numbers);
}

nlohmann::ordered_json parse_ordered_json(const std::string& text) {
  return parsed<nlohmann::ordered_json>(text, JsonNumbers::doubles);
}

nlohmann::json read_json(const std::filesystem::path& path, JsonNumbers numbers,
                         std::size_t bound) {
  const std::string text = read_file(path, bound);
  try {
    if (text.size() > bound) {
      throw std::invalid_argument(fmt::format("it has more than {} bytes", bound));
    }
    return parse_json(text, numbers);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path.string() + ": " + error.what());
  }
}

}  // namespace wavecurve::io
