#include "tools/commands/output/markup_table.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "wavecurve/filters/detail/characters.hpp"

namespace wavecurve::tools {

namespace {

using verification::is_digit;
using verification::PrintPart;

// --- numbers ---

/// How many characters a decimal has where.
struct DecimalShape {
  bool sign = false, exponent_sign = false;
  std::size_t integer = 0, decimals = 0, exponent = 0;
};

/// Nothing for what is no decimal in the plainest notation: -1.25, 1.25e-7.
std::optional<DecimalShape> shape_of(std::string_view text) {
  const auto take_sign = [&] {
    if (!text.starts_with('-') && !text.starts_with('+')) return false;
    text.remove_prefix(1);
    return true;
  };
  const auto take_digits = [&] {
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    const auto count = static_cast<std::size_t>(end - text.begin());
    text.remove_prefix(count);
    return count;
  };
  const auto take = [&](char c) {
    if (!text.starts_with(c)) return false;
    text.remove_prefix(1);
    return true;
  };
  DecimalShape shape;
  shape.sign = take_sign();
  shape.integer = take_digits();
  if (shape.integer == 0) return std::nullopt;
  if (take('.') && (shape.decimals = take_digits()) == 0) return std::nullopt;
  if (take('e')) {
    shape.exponent_sign = take_sign();
    if ((shape.exponent = take_digits()) == 0) return std::nullopt;
  }
  return text.empty() ? std::optional(shape) : std::nullopt;
}

/// What holds every number of a column; nothing for a column most of whose cells are none.
std::optional<DecimalShape> shape_of_column(const MarkupTable& table, std::size_t column) {
  DecimalShape widest;
  std::size_t numbers = 0, filled = 0;
  for (const auto& row : table.rows) {
    const std::string text = row[column].text();
    filled += text.empty() ? 0 : 1;
    const auto shape = shape_of(text);
    if (!shape) continue;
    ++numbers;
    widest = {widest.sign || shape->sign, widest.exponent_sign || shape->exponent_sign,
              std::max(widest.integer, shape->integer), std::max(widest.decimals, shape->decimals),
              std::max(widest.exponent, shape->exponent)};
  }
  return numbers > 0 && 2 * numbers >= filled ? std::optional(widest) : std::nullopt;
}

// --- Markdown ---

std::string markdown_text(std::string_view text) {
  constexpr std::string_view active = "\\`*_[]<>|~&$#";
  std::string result;
  for (const char c : printable(text)) {
    if (active.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

/// As a paragraph or an item of a list, which a hyphen or a plus sign would make a list.
std::string markdown_line(const std::string& text) {
  const bool is_list = text.starts_with('-') || text.starts_with('+');
  return (is_list ? "\\" : "") + markdown_text(text) + "\n";
}

std::string markdown_cell(const MarkupCell& cell) {
  std::string result;
  for (const auto& [text, departs] : cell.parts) {
    // Asterisks open and close nothing beside a sign.
    const bool is_bold = departs && !text.empty();
    result += is_bold ? "<b>" + markdown_text(text) + "</b>" : markdown_text(text);
  }
  return result;
}

// --- LaTeX ---

/// Signs that LaTeX takes for its own, or sets otherwise, or does not know.
constexpr std::pair<std::string_view, std::string_view> latex_signs[] = {
    {"\\", "\\textbackslash{}"},
    {"{", "\\{"},
    {"}", "\\}"},
    {"$", "\\$"},
    {"&", "\\&"},
    {"#", "\\#"},
    {"%", "\\%"},
    {"_", "\\_"},
    {"~", "\\textasciitilde{}"},
    {"^", "\\textasciicircum{}"},
    {"<", "\\textless{}"},
    {">", "\\textgreater{}"},
    {"|", "\\textbar{}"},
    {"\"", "\\char34{}"},
    {"[", "{[}"},
    {"]", "{]}"},
    {"*", "{*}"},
    {"--", "-{}"},
    {"−", "$-$"},
    {"×", "$\\times$"},
    {"·", "$\\cdot$"},
    {"½", "$\\frac{1}{2}$"},
};

std::string latex_text(std::string_view original) {
  const std::string shown = printable(original);
  std::string_view text = shown;
  std::string result;
  while (!text.empty()) {
    const auto sign = std::find_if(std::begin(latex_signs), std::end(latex_signs),
                                   [&](const auto& s) { return text.starts_with(s.first); });
    if (sign != std::end(latex_signs)) {
      result += sign->second;
      // The second of two hyphens may be the first of two more.
      text.remove_prefix(sign->first == "--" ? 1 : sign->first.size());
      continue;
    }
    result += text.front();
    text.remove_prefix(1);
  }
  return result;
}

std::string underlined(const std::string& latex) {
  return "\\underline{" + (latex.empty() ? "\\phantom{-}" : latex) + "}";
}

/// The parts of a decimal within dollar signs.
std::string latex_decimal(const MarkupCell& cell) {
  std::string result;
  for (const auto& [text, departs] : cell.parts) {
    std::string latex;
    for (const char c : text) latex += c == 'e' ? "\\mathrm{e}" : std::string(1, c);
    result += departs ? underlined(latex) : latex;
  }
  return "$" + result + "$";
}

std::string latex_cell(const MarkupCell& cell, bool is_number_column) {
  const std::string whole = cell.text();
  const bool is_number = shape_of(whole).has_value();
  if (is_number && !cell.is_marked()) return is_number_column ? whole : "\\num{" + whole + "}";
  std::string latex;
  if (is_number) {
    latex = latex_decimal(cell);
  } else {
    for (const auto& [text, departs] : cell.parts) {
      latex += departs ? underlined(latex_text(text)) : latex_text(text);
    }
  }
  return is_number_column && !latex.empty() ? "{" + latex + "}" : latex;
}

std::string column_type(const std::optional<DecimalShape>& shape) {
  if (!shape) return "l";
  std::string format = fmt::format("{}{}", shape->sign ? "-" : "", shape->integer);
  if (shape->decimals > 0) format += fmt::format(".{}", shape->decimals);
  if (shape->exponent > 0) {
    format += fmt::format("e{}{}", shape->exponent_sign ? "-" : "", shape->exponent);
  }
  return "S[table-format=" + format + "]";
}

std::string latex_row(const std::vector<std::string>& cells) {
  return fmt::format("    {} \\\\\n", fmt::join(cells, " & "));
}

}  // namespace

std::string MarkupCell::text() const {
  std::string result;
  for (const PrintPart& part : parts) result += part.text;
  return result;
}

bool MarkupCell::is_marked() const {
  return std::any_of(parts.begin(), parts.end(), [](const PrintPart& p) { return p.departs; });
}

std::string to_markdown(const MarkupTable& table) {
  std::string result = markdown_line(table.caption) + "\n|";
  for (const std::string& column : table.columns) result += " " + markdown_text(column) + " |";
  result += "\n|";
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    result += shape_of_column(table, i) ? " ---: |" : " :--- |";
  }
  result += "\n";
  for (const auto& row : table.rows) {
    result += "|";
    for (const MarkupCell& cell : row) result += " " + markdown_cell(cell) + " |";
    result += "\n";
  }
  if (!table.notes.empty()) result += "\n";
  for (const std::string& note : table.notes) result += "- " + markdown_line(note);
  return result;
}

std::string to_latex(const MarkupTable& table) {
  constexpr std::size_t rows_of_a_page = 40;
  const bool is_long = table.rows.size() > rows_of_a_page;
  std::vector<bool> is_number;
  std::vector<std::string> types, heads;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const auto shape = shape_of_column(table, i);
    is_number.push_back(shape.has_value());
    types.push_back(column_type(shape));
    // In an S column, braces tell text from a number.
    const std::string head = latex_text(table.columns[i]);
    heads.push_back(shape ? "{" + head + "}" : head);
  }
  const std::string type = fmt::format("{}", fmt::join(types, " "));
  const std::string caption = "\\caption{" + latex_text(table.caption) + "}";
  const std::string head = "    \\toprule\n" + latex_row(heads) + "    \\midrule\n";
  std::string result =
      fmt::format("% \\usepackage{{booktabs, siunitx{}}}\n", is_long ? ", longtable" : "");
  result += is_long ? fmt::format(
                          "\\begin{{longtable}}{{{}}}\n    {} \\\\\n{}    \\endhead\n"
                          "    \\bottomrule\n    \\endfoot\n",
                          type, caption, head)
                    : fmt::format(
                          "\\begin{{table}}\n  \\centering\n  {}\n"
                          "  \\begin{{tabular}}{{{}}}\n{}",
                          caption, type, head);
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < row.size(); ++i) {
      cells.push_back(latex_cell(row[i], is_number[i]));
    }
    result += latex_row(cells);
  }
  result += is_long ? "\\end{longtable}\n" : "    \\bottomrule\n  \\end{tabular}\n";
  for (const std::string& note : table.notes) {
    result += "  \\par\\smallskip{\\footnotesize " + latex_text(note) + "\\par}\n";
  }
  return is_long ? result : result + "\\end{table}\n";
}

bool is_markup(const std::string& format) { return format == "markdown" || format == "latex"; }

std::string to_markup(const MarkupTable& table, const std::string& format) {
  return format == "latex" ? to_latex(table) : to_markdown(table);
}

}  // namespace wavecurve::tools
