#include "tools/commands/number_format.hpp"

#include <cctype>
#include <utility>

#include <fmt/format.h>

namespace wavecurve::tools {

namespace {

std::string identifier(const std::string& name) {
  std::string result;
  for (const char c : name) {
    result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  if (result.empty() || std::isdigit(static_cast<unsigned char>(result.front())) != 0) {
    result.insert(result.begin(), 'f');
  }
  return result;
}

}  // namespace

void add_digits_option(CLI::App& command, int& digits) {
  command.add_option("--digits", digits, "Significant digits")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
}

void add_format_option(CLI::App& command, std::string& format, std::vector<std::string> accepted) {
  command.add_option("--format", format, "Form of the output")
      ->check(CLI::IsMember(std::move(accepted)))
      ->capture_default_str();
}

std::string header_opening(const std::string& title, const std::string& filter_name) {
  return fmt::format(
      "// {}, correctly rounded; written by wavecurve.\n#pragma once\n\n"
      "namespace wavecurve_tables::{} {{\n\n",
      title, identifier(filter_name));
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
