#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <sys/ioctl.h>
#include <unistd.h>
#include <vector>

#include <fmt/core.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/io/files/detail/output_folder.hpp"

#include "reports/terminal_table.hpp"
#include "reports/write_report.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/progress.hpp"
#include "tools/commands/terminal.hpp"
#include "verification/suite/claim.hpp"
#include "verification/suite/data_folder.hpp"
#include "verification/suite/reference.hpp"
#include "verification/suite/run_claims.hpp"

namespace wavecurve::tools {

namespace {

namespace fs = std::filesystem;
using namespace verification;

struct VerifyOptions {
  std::vector<std::string> only;
  bool list = false;
  bool bless = false;
  fs::path output, reference;
};

/// What the user did not name: in the source tree, or of an installed program the report where the
/// user stands and the reference among the program's data.
VerifyOptions with_defaults(VerifyOptions options) {
  const fs::path tree = source_tree();
  if (tree.empty() && options.bless && options.reference.empty()) {
    throw std::invalid_argument(
        "--bless: the reference of an installed program is fixed; name a file of your own by "
        "--reference, or bless in a clone by tools/verify.sh --bless");
  }
  if (options.output.empty()) {
    options.output = tree.empty() ? fs::path("wavecurve-report") : tree / "reports" / "latest";
  }
  if (options.reference.empty()) {
    options.reference =
        (tree.empty() ? data_folder() : tree / "reports") / "reference" / "verdicts.json";
  }
  return options;
}

std::vector<Claim> chosen_claims(const std::vector<std::string>& only) {
  if (only.empty()) return claims();
  for (const std::string& id : only) {
    if (std::ranges::find(claims(), id, &Claim::id) == claims().end()) {
      throw std::invalid_argument(unknown_name("claim", id, claims(), &Claim::id) +
                                  "; wavecurve verify --list says what they are");
    }
  }
  std::vector<Claim> chosen;
  std::ranges::copy_if(claims(), std::back_inserter(chosen), [&](const Claim& claim) {
    return std::ranges::find(only, claim.id) != only.end();
  });
  return chosen;
}

void list_claims() {
  std::size_t width = 0;
  for (const Claim& claim : claims()) width = std::max(width, claim.id.size());
  for (const Claim& claim : claims()) {
    fmt::print("{:{}}  {} ({})\n", claim.id, width, claim.title, claim.location);
  }
}

void show_progress(std::size_t finished, std::size_t total, const Claim& claim) {
  tell(fmt::format("\r\033[K{} of {} claims: {}", finished, total, claim.id));
  if (finished == total) tell("\r\033[K");
}

/// The columns of the terminal, or 0 where the output is a file or a pipe.
std::size_t terminal_width() {
  winsize size{};
  const bool known = isatty(STDOUT_FILENO) != 0 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0;
  return known ? size.ws_col : 0;
}

void print_changes(const std::vector<Change>& changes, const fs::path& reference) {
  fmt::print("\n{} since the blessed reference {}:\n",
             changes.size() == 1 ? "1 change" : fmt::format("{} changes", changes.size()),
             printable(reference.string()));
  for (const Change& change : changes) {
    const std::string line = fmt::format("{}: {}: blessed {}, own {}", change.id, change.what,
                                         change.blessed, change.own);
    fmt::print("  {}\n", printable(line));
  }
}

/// Names the claims whose computation failed, which are neither compared nor blessed.
bool report_failures(const std::vector<ClaimResult>& results) {
  bool has_failure = false;
  for (const ClaimResult& result : results) {
    if (result.outcome.failure.empty()) continue;
    has_failure = true;
    print_message(
        fmt::format("the computation of {} failed: {}", result.claim.id, result.outcome.failure));
  }
  return has_failure;
}

/// Runs the claims and writes the report.
std::vector<ClaimResult> run_and_report(const VerifyOptions& options,
                                        const std::vector<Claim>& chosen) {
  // Made before the work is done, so that a place that cannot be written is known at once.
  io::OutputFolder output(options.output);
  const std::string date = reports::date_of_report();

  const bool watched = isatty(STDERR_FILENO) != 0;
  auto results = run_claims(
      chosen, watched ? verification::Progress(show_progress) : verification::Progress());
  reports::write_report({{}, date, WAVECURVE_VERSION, results}, output.staging());
  output.publish();
  fmt::print("{}\nreport: {}\n", reports::terminal_table(results, terminal_width()),
             printable((options.output / "index.html").string()));
  return results;
}

void verify(const VerifyOptions& given, ExitCode& exit_code) {
  const VerifyOptions options = with_defaults(given);
  const std::vector<Claim> chosen = chosen_claims(options.only);
  const bool is_partial = !options.only.empty();
  const auto reference =
      options.bless ? std::vector<BlessedClaim>() : read_reference(options.reference);
  const auto results = run_and_report(options, chosen);
  if (report_failures(results)) exit_code = environment_failed;
  if (options.bless) {
    write_reference(options.reference, results, is_partial);
    fmt::print("blessed: {}\n", printable(options.reference.string()));
    return;
  }
  const auto changes = compare(reference, results, is_partial);
  if (changes.empty()) return;
  print_changes(changes, options.reference);
  if (exit_code == done) exit_code = differs;
}

}  // namespace

void add_verify_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand(
      "verify", "Compare every table, figure and claim of the publication with computed values");
  CLI::Option* list = command->add_flag("--list", options->list, "Name the claims and stop");
  command->add_option("--only", options->only, "Run only these claims")
      ->type_name("ID")
      ->excludes(list);
  command
      ->add_option("--output", options->output,
                   "Folder of the report; if not given, reports/latest of the source tree that the "
                   "program was built in, or wavecurve-report here if it is installed")
      ->type_name("DIR")
      ->excludes(list);
  command->add_flag("--bless", options->bless, "Make this run's verdicts and values the reference")
      ->excludes(list);
  command
      ->add_option("--reference", options->reference,
                   "File of the blessed verdicts; by default the program's own")
      ->type_name("FILE")
      ->excludes(list);
  command->callback([options, &exit_code] {
    if (options->list) {
      list_claims();
    } else {
      verify(*options, exit_code);
    }
  });
}

}  // namespace wavecurve::tools
