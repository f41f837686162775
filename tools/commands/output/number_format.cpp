#include "tools/commands/output/number_format.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/certified/rational.hpp"

#include "tools/commands/input/number_option.hpp"

namespace wavecurve::tools {

namespace {

/// What no namespace may be called: keywords, and macros that compilers define by themselves.
constexpr auto reserved_words = std::to_array<std::string_view>(
    {"alignas",      "alignof",      "and",           "and_eq",
     "asm",          "auto",         "bitand",        "bitor",
     "bool",         "break",        "case",          "catch",
     "char",         "char16_t",     "char32_t",      "char8_t",
     "class",        "co_await",     "co_return",     "co_yield",
     "compl",        "concept",      "const",         "const_cast",
     "consteval",    "constexpr",    "constinit",     "continue",
     "decltype",     "default",      "delete",        "do",
     "double",       "dynamic_cast", "else",          "enum",
     "explicit",     "export",       "extern",        "false",
     "float",        "for",          "friend",        "goto",
     "if",           "inline",       "int",           "linux",
     "long",         "mutable",      "namespace",     "new",
     "noexcept",     "not",          "not_eq",        "nullptr",
     "operator",     "or",           "or_eq",         "private",
     "protected",    "public",       "register",      "reinterpret_cast",
     "requires",     "return",       "short",         "signed",
     "sizeof",       "static",       "static_assert", "static_cast",
     "struct",       "switch",       "template",      "this",
     "thread_local", "throw",        "true",          "try",
     "typedef",      "typeid",       "typename",      "union",
     "unix",         "unsigned",     "using",         "virtual",
     "void",         "volatile",     "wchar_t",       "while",
     "xor",          "xor_eq"});

/// A name of C++ from any text: other signs than letters and digits become underscores. It neither
/// begins with one nor holds two in a row, which are the compiler's own.
std::string identifier(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (is_letter || (c >= '0' && c <= '9')) {
      result += c;
    } else if (!result.ends_with('_')) {
      result += '_';
    }
  }
  const bool is_digit_first = !result.empty() && result.front() >= '0' && result.front() <= '9';
  if (result.empty() || result.starts_with('_') || is_digit_first) result.insert(0, "f");
  if (std::ranges::find(reserved_words, result) != reserved_words.end()) result += '_';
  return result;
}

/// A text that stays within one comment: what is neither a visible sign of ASCII nor a blank
/// becomes a question mark, and so does a backslash, which might join the next line.
std::string comment_text(std::string_view text) {
  constexpr std::size_t longest = 200;
  std::string result(text.substr(0, longest));
  std::ranges::replace_if(
      result, [](char c) { return c < ' ' || c > '~' || c == '\\'; }, '?');
  return result + (text.size() > longest ? "..." : "");
}

}  // namespace

void add_digits_option(CLI::App& command, int& digits) {
  command.add_option("--digits", digits, "Significant digits")
      ->check(whole_number_from(1, 1000))
      ->capture_default_str();
}

void add_format_option(CLI::App& command, std::string& format, std::vector<std::string> accepted) {
  command.add_option("--format", format, "Output format")
      ->check(CLI::IsMember(std::move(accepted)))
      ->capture_default_str();
}

std::string accuracy_text(const std::vector<certified::DecimalEnclosure>& values) {
  const auto radius = [](const certified::DecimalEnclosure& value) {
    return certified::Rational::from_decimal(value.radius);
  };
  const auto least = std::ranges::max_element(
      values, [&](const auto& a, const auto& b) { return radius(a) < radius(b); });
  if (least == values.end() || radius(*least).is_zero()) return "every value is exact";
  return "every value is within " + least->radius + " of the true one";
}

std::string header_opening(const std::string& title, const std::string& filter_name) {
  return fmt::format(
      "// {}, correctly rounded; written by wavecurve.\n#pragma once\n\n"
      "namespace wavecurve_tables::{} {{\n\n",
      comment_text(title), identifier(filter_name));
}

std::string header_array(const std::string& name, const std::vector<std::string>& decimals) {
  std::string text = fmt::format("inline constexpr double {}[] = {{\n", name);
  for (const std::string& decimal : decimals) text += "    " + decimal + ",\n";
  return text + "};\n\n";
}

std::string header_closing(const std::string& filter_name) {
  return fmt::format("}}  // namespace wavecurve_tables::{}\n", identifier(filter_name));
}

}  // namespace wavecurve::tools
