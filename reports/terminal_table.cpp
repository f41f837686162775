#include "reports/terminal_table.hpp"

#include <algorithm>
#include <string_view>

namespace wavecurve::reports {

namespace {

using verification::ClaimResult;

bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

/// In characters of UTF-8, each of which is taken to fill one column.
std::size_t length(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, starts_character));
}

std::string pad(std::string_view text, std::size_t width) {
  return std::string(text) + std::string(width - std::min(width, length(text)), ' ');
}

/// Cut to `width` characters, the last an ellipsis where something is lost.
std::string cut(std::string line, std::size_t width) {
  if (width == 0 || length(line) <= width) return line;
  std::size_t end = 0;
  for (std::size_t characters = 0; end < line.size(); ++end) {
    if (starts_character(line[end]) && characters++ == width - 1) break;
  }
  return line.substr(0, end) + "…";
}

/// A value from a claim must not break the line or command the terminal.
std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  return text;
}

std::string counts_line(const std::vector<ClaimResult>& results) {
  std::string line =
      std::to_string(results.size()) + (results.size() == 1 ? " claim: " : " claims: ");
  const char* separator = "";
  for (const auto& [verdict, count] : count_verdicts(results)) {
    line += separator + std::to_string(count) + " " + std::string(to_string(verdict));
    separator = ", ";
  }
  return line;
}

}  // namespace

std::string terminal_table(const std::vector<ClaimResult>& results, std::size_t width) {
  std::size_t id_width = 0, verdict_width = 0;
  for (const auto& [claim, outcome] : results) {
    id_width = std::max(id_width, length(claim.id));
    verdict_width = std::max(verdict_width, to_string(outcome.verdict).size());
  }
  std::string table;
  for (const auto& [claim, outcome] : results) {
    table += cut(pad(claim.id, id_width) + "  " + pad(to_string(outcome.verdict), verdict_width) +
                     "  " + one_line(outcome.finding.sentence),
                 width) +
             "\n";
  }
  return table + "\n" + counts_line(results) + "\n";
}

}  // namespace wavecurve::reports
