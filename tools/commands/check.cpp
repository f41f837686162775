#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unistd.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/commands.hpp"
#include "tools/commands/output/check_data.hpp"
#include "tools/commands/output/check_page.hpp"
#include "tools/commands/output/check_text.hpp"
#include "tools/commands/output/number_format.hpp"
#include "verification/checker/check_table.hpp"

namespace wavecurve::tools {

namespace {

using verification::CheckedTable;

struct CheckOptions {
  std::string table, format = "text", page;
  bool explain = false;
};

/// The rule of no-color.org, and terminals that say of themselves that they have none.
bool shows_colour() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string_view(value == nullptr ? "" : value);
  };
  return ::isatty(STDOUT_FILENO) == 1 && variable("NO_COLOR").empty() && variable("TERM") != "dumb";
}

std::string formatted(const CheckedTable& table, const CheckOptions& options) {
  if (options.format == "json") return check_as_json(table);
  if (options.format == "csv") return check_as_csv(table);
  if (is_markup(options.format)) {
    return to_markup(check_as_markup(table, options.format == "latex"), options.format);
  }
  return check_as_text(table, {shows_colour(), options.explain});
}

void refuse_bad_options(const CheckOptions& options) {
  if (options.explain && options.format != "text") {
    throw std::invalid_argument(must_be("--format", options.format, "text with --explain"));
  }
  const std::string ending = std::filesystem::path(options.page).extension().string();
  if (!options.page.empty() && ending != ".html" && ending != ".htm") {
    throw std::invalid_argument(must_be("--output", options.page, "a file ending in .html"));
  }
}

void check_published_table(const CheckOptions& options, ExitCode& exit_code) {
  refuse_bad_options(options);
  const CheckedTable table =
      verification::check_table(verification::read_published_table(options.table));
  if (!options.page.empty()) io::write_file(options.page, check_as_page(table));
  const std::string text = formatted(table, options);
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (!table.is_right()) exit_code = differs;
}

}  // namespace

void add_check_command(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand(
      "check", "Compare the numbers of a published table with their certified values");
  command
      ->add_option(
          "table", options->table,
          "text with the columns filter, quantity, index, printed (or value), separated\n"
          "by commas, semicolons or tabs; \"# filter: db4\" and \"# quantity: h\" stand for\n"
          "columns of their own; other columns are kept; numbers in any usual form;\n"
          "quantities: h, g, dual(h), alpha, mu, nu, r, int(phi'', phi), phi, moment(psi), ...\n"
          "with *sqrt2, /sqrt2, /first (`coefficients --help` has them all);\n"
          "\"# convention: reversed, negated, alternating, dual, shift K, from 0, *sqrt2\" says how\n"
          "all columns depart from the library's order")
      ->required();
  add_format_option(*command, options->format, {"text", "json", "csv", "markdown", "latex"});
  command->add_option(
      "-o,--output", options->page,
      "Also write a page (.html) with the wrong digits marked, its rows to be chosen "
      "by verdict");
  command->add_flag("--explain", options->explain,
                    "Mark the digits that depart from the true value with carets");
  command->footer(
      "Verdicts: certified, form, published-route, misprint, agrees-to-digits, discrepant, "
      "undecided.\n"
      "Exit code: 0 if every value is right (certified, or right but for its form) in the "
      "library's\n"
      "order or one that the table states, 1 if not, 2 if the file is no such table.");
  command->callback([options, &exit_code] { check_published_table(*options, exit_code); });
}

}  // namespace wavecurve::tools
