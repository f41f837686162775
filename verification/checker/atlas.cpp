#include "verification/checker/atlas.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/elementary/logarithm.hpp"

namespace wavecurve::verification {

namespace {

bool is_right(const CheckedRow& row) {
  return row.verdict == PrintVerdict::certified || row.verdict == PrintVerdict::form;
}

std::string with_noun(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string name_of(const CheckedRow& row) {
  return fmt::format("{} {}_{}", row.entry.filter, to_string(row.entry.quantity),
                     row.entry.index.text());
}

/// For each filter and quantity the largest print, and the largest error.
int right_digits_of(const CheckedTable& table) {
  std::map<std::pair<std::string, std::string>, std::pair<double, double>> columns;
  int printed = 0;
  for (const CheckedRow& row : table.rows) {
    auto& [largest, error] = columns[{row.entry.filter, to_string(row.entry.quantity)}];
    const PrintedNumber& number = row.entry.number;
    largest = std::max(largest, std::abs(number.to_double()));
    printed = std::max(printed, number.significant_digits());
    if (is_right(row) || !std::isfinite(row.ulps)) continue;
    error = std::max(error, row.ulps * certified::Ball(number.unit()).to_double());
  }
  int digits = printed;
  for (const auto& [name, sizes] : columns) {
    const auto [largest, error] = sizes;
    if (error == 0 || largest == 0) continue;
    digits = std::min(digits, static_cast<int>(std::floor(logarithm_10(largest / error))));
  }
  return std::max(digits, 0);
}

/// Names of columns that share a property: "coif2 h, coif3 h".
using Shared = std::map<std::string, std::vector<std::string>>;

void say(const Shared& shared, std::vector<std::string>& causes) {
  constexpr std::size_t most_named = 4;
  for (const auto& [what, columns] : shared) {
    const std::size_t shown = std::min(columns.size(), most_named);
    std::string text = fmt::format(
        "{}",
        fmt::join(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
    if (columns.size() > shown) text += fmt::format(" and {} more", columns.size() - shown);
    causes.push_back(text + ": " + what);
  }
}

void say_what_columns_are(const CheckedTable& table, std::vector<std::string>& causes) {
  Shared conventions, solutions, routes;
  for (const CheckedColumn& column : table.columns) {
    const std::string name = fmt::format("{} {}", column.filter, to_string(column.quantity));
    if (!column.convention_text.empty()) {
      const std::string as = column.known_as.empty() ? "" : " (" + column.known_as + ")";
      conventions[column.convention_text + as].push_back(name);
    }
    if (!column.solution.empty()) solutions[column.solution].push_back(name);
    if (column.credited) routes[column.route].push_back(name);
  }
  say(conventions, causes);
  say(solutions, causes);
  say(routes, causes);
}

/// One sentence for each kind of single fault, with the entries.
void say_single_faults(const CheckedTable& table, std::vector<std::string>& causes) {
  Shared faults;
  for (const CheckedRow& row : table.rows) {
    if (row.verdict == PrintVerdict::misprint) {
      const auto end = std::min(row.detail.find_first_of(":;"), row.detail.size());
      faults[row.detail.substr(0, end)].push_back(name_of(row));
    } else if (row.verdict == PrintVerdict::agrees_to_digits &&
               row.detail.find("cut off") != std::string::npos) {
      faults["cut off instead of rounded"].push_back(name_of(row));
    }
  }
  say(faults, causes);
}

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.replace(at, 1, "\\|");
  }
  return text;
}

}  // namespace

AtlasEntry atlas_entry(const CheckedTable& table) {
  AtlasEntry entry;
  entry.file = std::filesystem::path(table.file).filename().string();
  entry.title = table.title;
  entry.numbers = static_cast<int>(table.rows.size());
  entry.right = static_cast<int>(std::count_if(table.rows.begin(), table.rows.end(), is_right));
  entry.wrong = entry.numbers - entry.right;
  entry.right_digits = right_digits_of(table);
  say_what_columns_are(table, entry.causes);
  say_single_faults(table, entry.causes);
  return entry;
}

std::vector<AtlasEntry> judge_atlas(const std::filesystem::path& folder) {
  std::set<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() == ".csv") files.insert(file.path());
  }
  std::vector<AtlasEntry> entries;
  for (const std::filesystem::path& file : files) {
    const PublishedTable table = read_published_table(file);
    entries.push_back(atlas_entry(check_table(table)));
    entries.back().source = table.source;
  }
  return entries;
}

std::string atlas_page(const std::vector<AtlasEntry>& entries) {
  const auto total = [&](int AtlasEntry::*member) {
    return std::accumulate(entries.begin(), entries.end(), 0,
                           [member](int sum, const AtlasEntry& e) { return sum + e.*member; });
  };
  std::string page = fmt::format(
      "# The atlas of tables that people copy\n\n"
      "<!-- Written by tools/generate_atlas.cpp from verification/published/atlas/*.csv. -->\n\n"
      "{} with {} numbers, judged by `wavecurve check`: {} numbers are right, {} are not. *Right to* "
      "counts the significant digits, of the largest entry of a column, in which the worst entry of "
      "the table is right. A table whose columns only stand in another order, sign or factor is "
      "judged as what it is.\n\n"
      "| table | numbers | right | wrong | right to | what made it |\n"
      "|---|---|---|---|---|---|\n",
      with_noun(entries.size(), "table"), total(&AtlasEntry::numbers), total(&AtlasEntry::right),
      total(&AtlasEntry::wrong));
  for (const AtlasEntry& entry : entries) {
    page += fmt::format("| `{}`: {} | {} | {} | {} | {} | {} |\n", entry.file, cell(entry.title),
                        entry.numbers, entry.right, entry.wrong,
                        with_noun(static_cast<std::size_t>(entry.right_digits), "digit"),
                        cell(fmt::format("{}", fmt::join(entry.causes, "; "))));
  }
  page += "\n## Sources\n\n";
  for (const AtlasEntry& entry : entries) {
    page += fmt::format("- `{}`: {}\n", entry.file, entry.source);
  }
  return page;
}

}  // namespace wavecurve::verification
