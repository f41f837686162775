#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verification/prints/marked_print.hpp"

namespace wavecurve::tools {

/// A cell of text, of which parts may be marked.
struct MarkupCell {
  std::vector<verification::PrintPart> parts;

  MarkupCell(std::string text) : parts{{std::move(text), false}} {}
  MarkupCell(std::vector<verification::PrintPart> marked) : parts(std::move(marked)) {}

  std::string text() const;
  bool is_marked() const;
};

/// A table for people's own documents.
struct MarkupTable {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<MarkupCell>> rows;  ///< each with a cell for every column
  std::vector<std::string> notes;             ///< sentences below it
};

/// A pipe table (GitHub's Markdown, Pandoc's), its columns of numbers flush right, marked parts bold, the
/// notes a list.
std::string to_markdown(const MarkupTable& table);

/// A table of LaTeX by the packages booktabs and siunitx, longer ones by longtable: columns of numbers
/// are S columns with their table-format, so that every digit stays and the points are in line;
/// marked parts are underlined, such a number is centred. Text is escaped.
std::string to_latex(const MarkupTable& table);

/// "markdown" or "latex".
bool is_markup(const std::string& format);
std::string to_markup(const MarkupTable& table, const std::string& format);

}  // namespace wavecurve::tools
