#include "reports/gnuplot.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/io/files/detail/run_program.hpp"
#include "wavecurve/io/files/detail/text.hpp"
#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "reports/formula.hpp"

namespace wavecurve::reports {

namespace {

namespace fs = std::filesystem;
using verification::Chart;

/// What all charts share: a readable size, generic fonts, line styles that differ in dashes and
/// point shape as well as in colour, and a light grid.
constexpr std::string_view chart_style = R"(set encoding utf8
set datafile separator tab
set datafile commentschars ""
set key autotitle columnheader
set key noenhanced outside top left horizontal reverse Left
set border 3 linecolor rgb "#555555"
set tics nomirror out scale 0.6
set grid linecolor rgb "#dddddd" linewidth 0.7
set linetype 1 linecolor rgb "#1f5a96" linewidth 2 dashtype 1 pointtype 7 pointsize 0.6
set linetype 2 linecolor rgb "#b3541e" linewidth 2 dashtype 2 pointtype 5 pointsize 0.6
set linetype 3 linecolor rgb "#2e7d4f" linewidth 2 dashtype 4 pointtype 9 pointsize 0.7
set linetype 4 linecolor rgb "#7b4a9e" linewidth 2 dashtype 3 pointtype 13 pointsize 0.7
set linetype 5 linecolor rgb "#333333" linewidth 2 dashtype 5 pointtype 4 pointsize 0.7
)";

std::string script_text(const Chart& chart) {
  std::string text = "# Draw anew: gnuplot -d " + chart.id + ".gp\n";
  text += "set terminal svg size 760,430 font \"sans-serif,14\" background rgb \"#ffffff\"\n";
  text += "set output \"" + chart.id + ".svg\"\n";
  text += chart_style;
  text += "data = \"" + chart.id + ".dat\"\n";
  text += chart.script;
  if (!text.ends_with('\n')) text += '\n';
  return text;
}

std::string data_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::string cell : cells) {
    std::ranges::replace_if(
        cell, [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
    // gnuplot would take a quotation mark for the beginning of a text that holds separators.
    std::ranges::replace(cell, '"', '\'');
    line += printable(cell) + "\t";
  }
  if (!line.empty()) line.back() = '\n';
  return line;
}

std::string data_text(const verification::Table& table) {
  std::string text = data_line(table.columns);
  for (const auto& row : table.rows) text += data_line(row);
  return text;
}

io::ProgramRun run_gnuplot(const std::string& script, const fs::path& directory) try {
  return io::run_program({"gnuplot", "-d", script}, directory);
} catch (const std::system_error& error) {
  throw std::system_error(error.code(), "cannot run gnuplot (Debian package gnuplot-nox)");
}

/// gnuplot echoes a faulty command before the line that says what is wrong with it,
/// "ID.gp" line 25: undefined variable: x. Lines of that form may be warnings, which explain nothing.
std::string first_complaint(std::string_view text, const std::string& script) {
  std::string_view first, error;
  for (const std::string_view line : io::split(text, "\n")) {
    if (first.empty()) first = line;
    const bool is_warning = line.find("arning:") != std::string_view::npos;
    if (error.empty() && !is_warning && line.starts_with("\"" + script + "\" line ")) error = line;
  }
  const std::string_view complaint = error.empty() ? first : error;
  return complaint.empty() ? "no reason given" : std::string(complaint);
}

/// The picture with the indices and exponents of its words set as such: gnuplot's own markup would take
/// every underscore of a name for one.
std::string with_formulas(std::string_view svg) {
  std::string result;
  for (;;) {
    const std::size_t begin = svg.find("<text>");
    const std::size_t end = begin == std::string_view::npos ? begin : svg.find("</text>", begin);
    if (end == std::string_view::npos) return result.append(svg);
    result.append(svg.substr(0, begin)).append(formula_text(svg.substr(begin, end - begin)));
    svg.remove_prefix(end);
  }
}

}  // namespace

void draw_chart(const Chart& chart, const fs::path& directory) {
  const std::string script = chart.id + ".gp";
  const fs::path picture = directory / (chart.id + ".svg");
  io::write_file(directory / script, script_text(chart));
  io::write_file(directory / (chart.id + ".dat"), data_text(chart.data));
  // An older picture must not pass for the one that gnuplot failed to draw.
  fs::remove(picture);
  const io::ProgramRun run = run_gnuplot(script, directory);
  if (run.exit_code != 0 || !fs::exists(picture)) {
    throw std::runtime_error("gnuplot failed on " + (directory / script).string() + ": " +
                             first_complaint(run.err, script));
  }
  // It does not notice a full disk.
  const std::string drawn = io::read_file(picture);
  if (drawn.find("</svg>") == std::string::npos) {
    throw std::runtime_error("cannot write " + picture.string() +
                             ": gnuplot did not write it to its end");
  }
  io::write_file(picture, with_formulas(drawn));
}

}  // namespace wavecurve::reports
