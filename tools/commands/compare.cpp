#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/io/files/detail/output_folder.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "reports/write_study.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/input/number_option.hpp"
#include "tools/commands/output/number_format.hpp"
#include "tools/commands/output/study_text.hpp"
#include "tools/commands/progress.hpp"
#include "tools/commands/terminal.hpp"
#include "verification/study/named_shapes.hpp"
#include "verification/study/study_journal.hpp"
#include "verification/study/study_json.hpp"

namespace wavecurve::tools {

namespace {

using namespace verification;

struct CompareOptions {
  std::vector<std::string> filters = {"db4"}, shapes = {"ellipse", "star", "dent"};
  std::vector<long> samples = {64};
  std::vector<int> levels;                              ///< empty: all of each size
  std::vector<double> dampings = {0, 0, 0, 0.1, 0, 1};  ///< s1, s2 of each
  std::vector<std::string> solvers;  ///< empty: all that solve the equation with mass
  std::string format = "text", directory;
};

/// Once each, in the order of the first.
template <class T>
void make_unique(std::vector<T>& list) {
  std::vector<T> result;
  for (const T& item : list) {
    if (std::ranges::find(result, item) == result.end()) result.push_back(item);
  }
  list = std::move(result);
}

CompareOptions completed(CompareOptions options) {
  for (const long samples : options.samples) check_samples(samples);
  if (options.dampings.size() % 2 != 0) {
    throw std::invalid_argument(fmt::format("--damping has {} numbers, but must have pairs s1,s2",
                                            options.dampings.size()));
  }
  if (options.solvers.empty()) {
    for (const dynamics::NamedSolver& solver : dynamics::solvers()) {
      if (!solver.is_massless) options.solvers.push_back(solver.name);
    }
  }
  make_unique(options.solvers);
  return options;
}

StudyPlan plan_of(const CompareOptions& options) {
  StudyPlan plan{{}, options.solvers};
  for (const std::string& filter : options.filters) {
    for (const long samples : options.samples) {
      const auto levels =
          options.levels.empty() ? std::vector<int>{all_levels(samples)} : options.levels;
      for (const int level : levels) {
        for (const std::string& shape : options.shapes) {
          for (std::size_t i = 0; i < options.dampings.size(); i += 2) {
            plan.settings.push_back(
                {filter, samples, level, shape, options.dampings[i], options.dampings[i + 1]});
          }
        }
      }
    }
  }
  make_unique(plan.settings);
  return plan;
}

std::vector<StudyPoint> points_of(const CompareOptions& options) {
  StudyHooks hooks;
  std::optional<StudyJournal> journal;
  if (!options.directory.empty()) {
    journal.emplace(std::filesystem::path(options.directory) / "compare.points.jsonl");
    for (const std::string& warning : journal->warnings()) print_message(warning);
    hooks.known = journal->points();
    hooks.finished = [&](const StudyPoint& point) { journal->append(point); };
  }
  Progress progress("points");
  hooks.progress = [&](std::size_t done, std::size_t all) { progress.show(done, all); };
  return run_study(plan_of(options), hooks);
}

/// The tables, then what those of several settings come to.
std::string study_as_text(const std::vector<StudyPoint>& points, const StudySummary& summary,
                          const std::filesystem::path& directory) {
  std::string text = study_text(points, summary);
  const auto sentences = reports::answer(points, summary);
  if (settings_of(points).size() > 1) text += fmt::format("\n{}\n", fmt::join(sentences, "\n"));
  return text + (directory.empty() ? "\n-o DIR also writes a page of charts\n"
                                   : fmt::format("\nreport: {}\n",
                                                 printable((directory / "index.html").string())));
}

void compare_solvers(const CompareOptions& given) {
  const CompareOptions options = completed(given);
  const std::filesystem::path directory = options.directory;
  std::optional<io::OutputFolder> output;
  if (!directory.empty()) output.emplace(directory);
  const std::vector<StudyPoint> points = points_of(options);
  const StudySummary summary = summarize(points);
  if (output) {
    io::write_file(output->staging() / "compare.json", to_json(points, summary));
    io::write_file(output->staging() / "compare.csv", study_csv(points));
    reports::write_study(points, summary, output->staging());
    output->publish();
  }
  const std::string text = options.format == "json"  ? to_json(points, summary)
                           : options.format == "csv" ? study_csv(points)
                                                     : study_as_text(points, summary, directory);
  if (options.format == "text") {
    print_text(text);
  } else {
    std::fputs(text.c_str(), stdout);
  }
}

}  // namespace

void add_compare_command(CLI::App& app, ExitCode&) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand(
      "compare",
      "Compare errors and costs of the solvers of the equation of motion with the exact solution. "
      "--filter, --samples, --levels, --shape and --damping may each be a list; the study is their "
      "product and uses all cores. Times are processor time of one thread, the minimum of up to "
      "five runs.");
  command->add_option("--filter", options->filters, "Filter names, or paths to JSON filter files")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--samples", options->samples, "Numbers of samples, powers of two")
      ->check(samples_check())
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--levels", options->levels, "Levels of decomposition; all by default")
      ->delimiter(',')
      ->check(levels_check());
  command
      ->add_option("--shape", options->shapes,
                   "ellipse, star, dent, or the first contour of a drawing (.svg, .csv), fitted to "
                   "the unit circle, which is the rest shape")
      ->delimiter(',')
      ->capture_default_str();
  command
      ->add_option("--damping", options->dampings,
                   "s1,s2 of the damping C = s1 M + s2 K; may be repeated")
      ->check(number_from(0, 1e12))
      ->delimiter(',')
      ->default_str("0,0 0,0.1 0,1");
  command
      ->add_option("--solvers", options->solvers,
                   "Solver names, separated by commas; all by default")
      ->delimiter(',');
  add_format_option(*command, options->format, {"text", "json", "csv"});
  command->add_option(
      "-o,--output", options->directory,
      "Also write index.html with charts, compare.json and compare.csv into this folder. Finished "
      "points are kept there in compare.points.jsonl, from which an interrupted run resumes "
      "(remove the file to measure again)");
  command->callback([options] { compare_solvers(*options); });
}

}  // namespace wavecurve::tools
