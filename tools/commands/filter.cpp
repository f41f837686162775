#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "wavecurve/certified/decimal_enclosure.hpp"
#include "wavecurve/certified/detail/families/families.hpp"
#include "wavecurve/certified/detail/refine.hpp"
#include "wavecurve/certified/diagnostics.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/certified/sobolev_exponent.hpp"
#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/io/files/detail/csv.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"
#include "wavecurve/io/load_filter.hpp"

#include "tools/commands/commands.hpp"
#include "tools/commands/output/markup_table.hpp"
#include "tools/commands/output/number_format.hpp"

namespace wavecurve::tools {

namespace {

using certified::Ball;
using certified::FilterDefinition;
using nlohmann::ordered_json;

struct FilterOptions {
  std::string name;
  bool list = false;
  int digits = 40;
  std::string format = "text";
};

/// The four filters by the names that files and headers use.
struct NamedFilter {
  const char* name;
  Filter<std::string> decimals;
};

std::string tap_decimal(const Ball& tap, int digits) {
  return certified::supported_decimal(tap, digits).value;
}

/// Correctly rounded decimals of all four filters. Raises the precision until every tap is decided;
/// the decimals of a user's own filter may not support as many digits as are asked for.
std::vector<NamedFilter> rounded_filters(const FilterDefinition& definition, int digits) {
  FilterBank<Ball> bank;
  const auto attempt = [&](long bits) {
    bank = definition.bank(bits);
    bool decided = true;
    for (const auto* low : {&bank.analysis_low, &bank.synthesis_low}) {
      for (const Ball& tap : low->taps) decided &= decimal_enclosure(tap, digits).has_value();
    }
    return decided;
  };
  certified::refine(certified::bits_for_digits(digits), attempt,
                    definition.known_bits ? definition.known_bits : definition.dual_known_bits);
  const auto round = [digits](const char* name, const Filter<Ball>& filter) {
    NamedFilter result{name, {filter.first_index, {}}};
    for (const Ball& tap : filter.taps) result.decimals.taps.push_back(tap_decimal(tap, digits));
    return result;
  };
  return {round("analysis_low", bank.analysis_low), round("analysis_high", bank.analysis_high),
          round("synthesis_low", bank.synthesis_low), round("synthesis_high", bank.synthesis_high)};
}

/// The digits that are proved, at most ten; null where there is none.
ordered_json short_decimal(const Ball& x) {
  constexpr int shown = 10;
  const auto decimal = certified::supported_decimal(x, shown);
  if (decimal.value == "0" && decimal.radius != "0") return nullptr;
  return decimal.value;
}

std::string symmetry_text(const Filter<Ball>& filter) {
  switch (certified::symmetry(filter)) {
    case certified::Symmetry::symmetric:
      return "symmetric";
    case certified::Symmetry::antisymmetric:
      return "antisymmetric";
    case certified::Symmetry::none:
      return "none";
  }
  return {};
}

/// Null where the taps of a user's filter have too few digits to tell.
ordered_json exponent_json(const FilterDefinition& definition) {
  try {
    return short_decimal(sobolev_exponent(definition));
  } catch (const std::domain_error&) {
    return nullptr;
  }
}

ordered_json riesz_json(const FilterDefinition& definition) {
  const auto bounds = certified::riesz_bounds(definition);
  if (!bounds) return nullptr;
  ordered_json both{short_decimal(bounds->lower), short_decimal(bounds->upper)};
  return both[0].is_null() || both[1].is_null() ? ordered_json() : both;
}

ordered_json diagnostics(const FilterDefinition& definition) {
  constexpr long bits = 128;
  const certified::WorkingPrecision precision(bits);
  const auto bank = definition.bank(bits);
  const FilterDefinition dual = certified::dual(definition);
  const auto psi = certified::wavelet_support(bank);
  const bool orthonormal = bank.is_orthonormal();
  const ordered_json riesz = riesz_json(definition);
  // Where the shifts of phi are no Riesz basis, what is computed is but a bound of the exponent.
  const ordered_json exponent =
      orthonormal && riesz.is_null() ? ordered_json() : exponent_json(definition);
  return {{"orthonormal", orthonormal},
          {"vanishing_moments", bank.vanishing_moments},
          {"dual_vanishing_moments", bank.dual_vanishing_moments},
          {"support", {bank.synthesis_low.first_index, bank.synthesis_low.last_index()}},
          {"dual_support", {bank.analysis_low.first_index, bank.analysis_low.last_index()}},
          {"wavelet_support", {psi.first, psi.second}},
          {"sobolev_exponent", exponent},
          {"dual_sobolev_exponent", orthonormal ? exponent : exponent_json(dual)},
          {"riesz_bounds", riesz},
          {"dual_riesz_bounds", orthonormal ? riesz : riesz_json(dual)},
          {"symmetry", symmetry_text(bank.synthesis_low)},
          {"dual_symmetry", symmetry_text(bank.analysis_low)}};
}

std::string filter_as_json(const FilterDefinition& definition,
                           const std::vector<NamedFilter>& filters) {
  ordered_json document{{"filter", definition.name}};
  for (const auto& [name, filter] : filters) {
    document[name] = {{"first_index", filter.first_index}, {"taps", filter.taps}};
  }
  document["diagnostics"] = diagnostics(definition);
  return io::json_text(document, 2) + "\n";
}

std::string filter_as_csv(const FilterDefinition& definition,
                          const std::vector<NamedFilter>& filters) {
  std::string text = "filter,part,index,tap\n";
  for (const auto& [name, filter] : filters) {
    for (int n = filter.first_index; n <= filter.last_index(); ++n) {
      text += fmt::format("{},{},{},{}\n", io::csv_field(definition.name), name, n, filter[n]);
    }
  }
  return text;
}

std::string filter_as_cpp(const FilterDefinition& definition,
                          const std::vector<NamedFilter>& filters) {
  std::string text = header_opening("filter " + definition.name, definition.name);
  for (const auto& [name, filter] : filters) {
    text += fmt::format("inline constexpr int {}_first_index = {};\n", name, filter.first_index);
    text += header_array(name, filter.taps);
  }
  return text + header_closing(definition.name);
}

std::string filter_as_text(const FilterDefinition& definition,
                           const std::vector<NamedFilter>& filters) {
  std::string text = "filter " + printable(definition.name) + "\n";
  const ordered_json facts = diagnostics(definition);
  const bool has_inaccurate_taps = definition.known_bits || definition.dual_known_bits;
  for (const auto& [key, value] : facts.items()) {
    std::string label = key;
    for (char& c : label) c = c == '_' ? ' ' : c;
    std::string shown = value.dump();
    std::erase(shown, '"');
    if (has_inaccurate_taps && label.ends_with("moments")) shown += ", to the accuracy of the taps";
    text += fmt::format("  {:<24}{}\n", label, value.is_null() ? "not known, or none" : shown);
  }
  const bool orthonormal = facts.at("orthonormal");
  for (const auto& [name, filter] : filters) {
    if (orthonormal && std::string_view(name).starts_with("synthesis")) continue;
    text += fmt::format("\n{}{}\n", name, orthonormal ? " (synthesis is the same)" : "");
    for (int n = filter.first_index; n <= filter.last_index(); ++n) {
      const std::string& tap = filter.taps[static_cast<std::size_t>(n - filter.first_index)];
      text += fmt::format("{:>6}  {}{}\n", n, tap.starts_with('-') ? "" : " ", tap);
    }
  }
  return text;
}

/// The filters side by side over their common indices; where both sides are the same, one of them.
MarkupTable filter_as_markup(const FilterDefinition& definition,
                             const std::vector<NamedFilter>& filters) {
  const bool orthonormal = definition.bank(certified::bits_for_digits(1)).is_orthonormal();
  MarkupTable table{"Filter " + definition.name, {"index"}, {}, {}};
  int first = filters.front().decimals.first_index, last = first;
  for (const auto& [name, filter] : filters) {
    first = std::min(first, filter.first_index);
    last = std::max(last, filter.last_index());
  }
  for (int n = first; n <= last; ++n) table.rows.push_back({std::to_string(n)});
  for (const auto& [name, filter] : filters) {
    std::string heading = name;
    std::ranges::replace(heading, '_', ' ');
    if (orthonormal && heading.starts_with("synthesis")) continue;
    table.columns.push_back(heading);
    for (int n = first; n <= last; ++n) {
      const bool has_tap = n >= filter.first_index && n <= filter.last_index();
      table.rows[static_cast<std::size_t>(n - first)].push_back(has_tap ? filter[n] : "");
    }
  }
  if (orthonormal) table.notes.push_back("The synthesis filters are the same.");
  return table;
}

/// Every family with what it says of its names, and its members with their aliases.
std::string list_of_filters() {
  std::string text;
  for (const certified::Family& family : certified::families()) {
    text += fmt::format("{}{}\n", text.empty() ? "" : "\n", family.names);
    for (const std::string& member : family.members) {
      std::vector<std::string> aliases;
      for (const auto& [alias, name] : family.aliases) {
        if (name == member) aliases.push_back(alias);
      }
      text += aliases.empty() ? fmt::format("  {}\n", member)
                              : fmt::format("  {:<12}{}\n", member, fmt::join(aliases, ", "));
    }
  }
  return text;
}

void run_filter(const FilterOptions& options) {
  if (options.list) {
    std::fputs(list_of_filters().c_str(), stdout);
    return;
  }
  if (options.name.empty()) {
    throw std::invalid_argument("filter: a NAME is required (wavecurve filter --list names them)");
  }
  const FilterDefinition definition = io::load_filter(options.name);
  const auto filters = rounded_filters(definition, options.digits);
  std::string text;
  if (options.format == "json") text = filter_as_json(definition, filters);
  if (options.format == "csv") text = filter_as_csv(definition, filters);
  if (options.format == "cpp") text = filter_as_cpp(definition, filters);
  if (options.format == "text") text = filter_as_text(definition, filters);
  if (is_markup(options.format)) {
    text = to_markup(filter_as_markup(definition, filters), options.format);
  }
  std::fputs(text.c_str(), stdout);
}

}  // namespace

void add_filter_command(CLI::App& app, ExitCode&) {
  auto options = std::make_shared<FilterOptions>();
  CLI::App* command = app.add_subcommand("filter", "Print a filter bank, correctly rounded");
  CLI::Option* name =
      command->add_option("NAME", options->name, "Filter name, or path to a JSON filter file");
  add_digits_option(*command, options->digits);
  add_format_option(*command, options->format, {"text", "json", "csv", "cpp", "markdown", "latex"});
  command->add_flag("--list", options->list, "Name all families, filters and aliases, and stop")
      ->excludes(name, command->get_option("--digits"), command->get_option("--format"));
  command->footer(
      "A JSON filter file: {\"taps\": [\"0.48...\", ...]}, and where they are needed\n"
      "first_index   of the taps, 0 unless given\n"
      "sum           of the taps: \"sqrt2\", \"1\" or \"2\"\n"
      "dual          {\"taps\": [...], \"first_index\": ...}, the analysis side of a biorthogonal pair\n"
      "accuracy      a bound of the error of every tap, where it is not half a unit of its last digit\n"
      "vanishing_moments, dual_vanishing_moments, name\n"
      "sum and accuracy may be given for each side: {\"primal\": \"2\", \"dual\": \"1\"}. Taps are "
      "decimals,\n"
      "of which every digit counts, or fractions \"75/64\"; a zero is exact.");
  command->callback([options] { run_filter(*options); });
}

}  // namespace wavecurve::tools
