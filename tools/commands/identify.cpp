#include "verification/identify/identify.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/io/files/detail/csv.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"
#include "wavecurve/io/files/read_file.hpp"

#include "tools/commands/commands.hpp"
#include "tools/commands/output/markup_table.hpp"
#include "tools/commands/output/number_format.hpp"
#include "tools/commands/terminal.hpp"

namespace wavecurve::tools {

namespace {

using namespace wavecurve::verification;
using nlohmann::ordered_json;

constexpr std::size_t most_matches = 5;
/// More than a table of lists that anyone would read has.
constexpr std::size_t largest_list_file = std::size_t{16} << 20;

struct IdentifyOptions {
  std::string file = "-", format = "text";
  bool as_table = false;
};

struct IdentifiedList {
  NumberList list;
  std::vector<Match> matches;
};

std::string package_of(const Match& match) {
  if (!match.in_order || match.convention.shift != 0 || match.convention.half_powers != 0)
    return "";
  FilterValues filter(certified::find_filter(match.column->filter));
  return known_as(filter, match.column->quantity, match.convention);
}

/// "reversed, negated, times sqrt2": what stands between the list and the library's column.
std::string convention_words(const Match& match) {
  std::vector<std::string> words;
  const Convention& c = match.convention;
  if (!match.in_order) words.push_back("in another order");
  if (c.reversed) words.push_back("reversed");
  if (c.negated) words.push_back("negated");
  if (c.alternating) words.push_back("alternating");
  if (c.shift != 0) words.push_back(fmt::format("shift {}", c.shift));
  if (!match.scale_is_power || c.half_powers != 0) words.push_back("times " + scale_text(match));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string match_text(const Match& match) {
  std::string text = fmt::format("{} {}", match.column->filter, to_string(match.column->quantity));
  if (const std::string words = convention_words(match); !words.empty()) text += ", " + words;
  if (const std::string package = package_of(match); !package.empty()) text += ", as " + package;
  return text +
         fmt::format(": {} of {} numbers, {:.1f} digits", match.matched, match.of, match.digits);
}

std::string title_of(const IdentifiedList& identified, std::size_t number) {
  const std::string name =
      identified.list.name.empty() ? fmt::format("list {}", number) : identified.list.name;
  const std::size_t count = identified.list.numbers.size();
  return fmt::format("{} ({} number{})", name, count, count == 1 ? "" : "s");
}

std::string as_text(const std::vector<IdentifiedList>& lists) {
  std::string text;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    text += (i == 0 ? "" : "\n") + title_of(lists[i], i + 1) + "\n";
    const auto& matches = lists[i].matches;
    for (std::size_t m = 0; m < std::min(matches.size(), most_matches); ++m) {
      text += fmt::format("  {}{}\n", m == 0 ? "" : "or ", match_text(matches[m]));
    }
    text += matches.empty() ? "  no known column" : "  no other filter";
    text += "; the nearest by the sizes of the entries, divided by the largest:\n";
    for (const NearMiss& miss : nearest_columns(lists[i].list, matches)) {
      text += fmt::format("    {} {}: off by {:.2g}\n", miss.column->filter,
                          to_string(miss.column->quantity), miss.distance);
    }
  }
  return text;
}

/// A row for each match, the best first; below the table the runners-up of every list.
MarkupTable as_markup(const std::vector<IdentifiedList>& lists) {
  MarkupTable table{
      "What the lists of numbers are",
      {"list", "filter", "quantity", "departs by", "matched", "of", "digits", "known as"},
      {},
      {}};
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const auto& [list, matches] = lists[i];
    const std::string title = title_of(lists[i], i + 1);
    for (std::size_t m = 0; m < std::min(matches.size(), most_matches); ++m) {
      const Match& match = matches[m];
      table.rows.push_back({title, match.column->filter, to_string(match.column->quantity),
                            convention_words(match), std::to_string(match.matched),
                            std::to_string(match.of), fmt::format("{:.1f}", match.digits),
                            package_of(match)});
    }
    std::vector<std::string> misses;
    for (const NearMiss& miss : nearest_columns(list, matches)) {
      misses.push_back(fmt::format("{} {} (off by {:.2g})", miss.column->filter,
                                   to_string(miss.column->quantity), miss.distance));
    }
    table.notes.push_back(fmt::format("{}: {}; the nearest: {}", title,
                                      matches.empty() ? "no known column" : "no other filter",
                                      fmt::join(misses, ", ")));
  }
  return table;
}

ordered_json as_json(const Match& match) {
  const Convention& c = match.convention;
  return {{"filter", match.column->filter},
          {"quantity", to_string(match.column->quantity)},
          {"reversed", c.reversed},
          {"negated", c.negated},
          {"alternating", c.alternating},
          {"scale", scale_text(match)},
          {"shift", c.shift},
          {"in_order", match.in_order},
          {"digits", std::stod(fmt::format("{:.1f}", match.digits))},
          {"matched", match.matched},
          {"of", match.of},
          {"known_as", package_of(match)}};
}

std::string as_json(const std::vector<IdentifiedList>& lists) {
  ordered_json columns = ordered_json::array();
  for (const IdentifiedList& identified : lists) {
    ordered_json column{{"name", identified.list.name},
                        {"numbers", identified.list.numbers.size()},
                        {"matches", ordered_json::array()}};
    const auto& matches = identified.matches;
    for (std::size_t m = 0; m < std::min(matches.size(), most_matches); ++m) {
      column["matches"].push_back(as_json(matches[m]));
    }
    column["nearest"] = ordered_json::array();
    for (const NearMiss& miss : nearest_columns(identified.list, matches)) {
      column["nearest"].push_back({{"filter", miss.column->filter},
                                   {"quantity", to_string(miss.column->quantity)},
                                   {"distance", std::stod(fmt::format("{:.3g}", miss.distance))}});
    }
    columns.push_back(std::move(column));
  }
  return io::json_text(ordered_json{{"columns", columns}}, 2) + "\n";
}

/// The list as a table that `check` reads. A convention holds for all columns of a table, so that
/// one list makes a table; of several the first that is identified.
std::string as_check_table(const std::vector<IdentifiedList>& lists) {
  for (const auto& [list, matches] : lists) {
    if (matches.empty() || !matches.front().in_order || !matches.front().scale_is_power) continue;
    const Match& match = matches.front();
    std::string text = fmt::format("# title: identified as {}\n", match_text(match));
    Convention stated = match.convention;
    std::vector<std::string> words;
    if (stated.reversed) words.push_back("reversed");
    if (stated.negated) words.push_back("negated");
    if (stated.alternating) words.push_back("alternating");
    if (stated.shift != 0) words.push_back(fmt::format("shift {}", stated.shift));
    if (stated.half_powers != 0) words.push_back(factor_text(stated.half_powers));
    if (!words.empty()) text += fmt::format("# convention: {}\n", fmt::join(words, ", "));
    text += "filter,quantity,index,printed\n";
    const int first = list.first_index.value_or(match.column->values.first_index);
    for (std::size_t i = 0; i < list.numbers.size(); ++i) {
      text += fmt::format("{},{},{},{}\n", match.column->filter,
                          io::csv_field(to_string(match.column->quantity)),
                          first + static_cast<int>(i), list.numbers[i].text());
    }
    return text;
  }
  throw std::invalid_argument("no list was identified, so that there is no table to write");
}

void run_identify(const IdentifyOptions& options, ExitCode& exit_code) {
  const std::string text =
      io::read_file(options.file == "-" ? "/dev/stdin" : options.file, largest_list_file);
  std::vector<IdentifiedList> lists;
  for (NumberList& list : read_number_lists(text)) {
    std::vector<Match> matches = identify(list);
    lists.push_back({std::move(list), std::move(matches)});
  }
  const std::string output = options.as_table           ? as_check_table(lists)
                             : options.format == "json" ? as_json(lists)
                             : is_markup(options.format)
                                 ? to_markup(as_markup(lists), options.format)
                                 : as_text(lists);
  if (options.as_table || options.format != "text") {
    std::fwrite(output.data(), 1, output.size(), stdout);
  } else {
    print_text(output);
  }
  const bool all_found = std::all_of(lists.begin(), lists.end(),
                                     [](const IdentifiedList& l) { return !l.matches.empty(); });
  if (!all_found) exit_code = differs;
}

}  // namespace

void add_identify_command(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<IdentifyOptions>();
  CLI::App* command =
      app.add_subcommand("identify", "Find the filter and quantity that a list of numbers shows");
  command->add_option("FILE", options->file,
                      "File with numbers in nearly any form (a column, a literal of C, Python, "
                      "MATLAB, R, Julia\nor Fortran, a LaTeX or Markdown table), or - for standard "
                      "input");
  add_format_option(*command, options->format, {"text", "json", "markdown", "latex"});
  command
      ->add_flag("--table", options->as_table,
                 "Print the first list that is found as a table for `check`")
      ->excludes(command->get_option("--format"));
  command->footer(
      "Exit code: 0 if every list is found, 1 if one is not, 2 if the input has no numbers.");
  command->callback([options, &exit_code] { run_identify(*options, exit_code); });
}

}  // namespace wavecurve::tools
