#include <algorithm>
#include <charconv>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/io/files/detail/output_folder.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/commands.hpp"
#include "tools/commands/compare_merge.hpp"
#include "tools/commands/input/number_option.hpp"
#include "tools/commands/output/number_format.hpp"
#include "tools/commands/output/study_files.hpp"
#include "tools/commands/progress.hpp"
#include "tools/commands/started_ranks.hpp"
#include "tools/commands/terminal.hpp"
#include "verification/study/named_shapes.hpp"
#include "verification/study/solver_study.hpp"
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
  Shard shard;
  bool one_a_core = false;
  std::vector<std::string> merged;  ///< folders of runs to be joined
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

/// On all cores, or with a team of other processes.
std::vector<StudyPoint> computed(const StudyPlan& plan, const CompareOptions& options,
                                 std::optional<Team>& team) {
  StudyHooks hooks;
  std::optional<StudyJournal> journal;
  if (!options.directory.empty()) {
    const std::filesystem::path directory = options.directory;
    journal.emplace(directory / journal_name);
    hooks.known = [&, directory](const auto& take) {
      // A part is never published, but joined from what stands here. The plan has been found to be good.
      if (options.shard.count > 1) io::write_file(directory / plan_name, to_json(plan));
      journal->read(take);
      for (const std::string& warning : journal->warnings()) print_message(warning);
    };
    hooks.finished = [&](const StudyPoint& point) { journal->append(point); };
  }
  Progress progress("points");
  hooks.progress = [&](std::size_t done, std::size_t all) { progress.show(done, all); };
  return team ? run_study(*team, plan, hooks, options.shard)
              : run_study(plan, hooks, options.shard);
}

/// What the processes but the first do. Whatever keeps one of them away is for the first to say.
void take_part(Ranks& ranks, const StudyPlan& plan, const CompareOptions& options) {
  try {
    if (options.one_a_core) keep_to_a_core(ranks);
  } catch (const std::exception& error) {
    return decline(ranks, error.what());
  }
  follow(ranks, plan, {}, options.shard);
}

void compare_solvers(const CompareOptions& given) {
  const CompareOptions options = completed(given);
  const StudyPlan plan = plan_of(options);
  const std::unique_ptr<Ranks> ranks = started_ranks();
  if (ranks && ranks->rank() != 0) return take_part(*ranks, plan, options);
  std::optional<Team> team;
  if (ranks) team.emplace(*ranks);
  if (ranks && options.one_a_core) keep_to_a_core(*ranks);
  std::optional<io::OutputFolder> output;
  if (!options.directory.empty()) output.emplace(options.directory);
  const std::vector<StudyPoint> points = computed(plan, options, team);
  team.reset();
  const bool is_whole = options.shard.count == 1;
  if (!is_whole && options.format == "text") {
    print_text(
        fmt::format("shard {}/{}: {} points are in {}\n", options.shard.index, options.shard.count,
                    points.size(),
                    printable((std::filesystem::path(options.directory) / journal_name).string())));
    return;
  }
  const StudySummary summary = summarize(points);
  if (output && is_whole) {
    write_study_files(plan, points, summary, output->staging());
    output->publish();
  }
  print_study(points, summary, options.format, options.directory);
  if (options.one_a_core && options.format == "text") {
    print_text(fmt::format("measured with {} side by side, each process on a core of its own\n",
                           ranks ? ranks->local_count() : 1));
  }
}

Shard shard_of(const std::string& text) {
  const auto number = [&](std::string_view part) {
    std::size_t value = 0;
    const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    const bool is_whole = error == std::errc() && stop == part.data() + part.size();
    constexpr std::size_t most = 1000000;
    if (!is_whole || value < 1 || value > most) {
      throw std::invalid_argument(
          fmt::format("--shard {}: must be I/N with 1 <= I <= N <= {}", text, most));
    }
    return value;
  };
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::string_view all = text;
  const Shard shard{number(all.substr(0, slash)),
                    number(all.substr(std::min(slash + 1, all.size())))};
  if (shard.index > shard.count) {
    throw std::invalid_argument(
        fmt::format("--shard {}: must be I/N with 1 <= I <= N, but {} is above {}", text,
                    shard.index, shard.count));
  }
  return shard;
}

}  // namespace

void add_compare_command(CLI::App& app, ExitCode& exit_code) {
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
  auto shard = std::make_shared<std::string>();
  command->add_option(
      "--shard", *shard,
      "I/N: compute the I-th of N parts of the study, for as many machines; each has its own -o DIR, "
      "and --merge joins them");
  command
      ->add_option("--merge", options->merged,
                   "Join the points of these folders of one study into -o DIR, without computing "
                   "anything; exit code 1 if points are missing. The study is that of the folders; "
                   "the other lists do not count")
      ->expected(1, CLI::detail::expected_max_vector_size);
  command->add_flag(
      "--one-a-core", options->one_a_core,
      "Under mpirun: keep each process to a core of its own, refuse more processes than "
      "cores, and say how many ran side by side, so that times can be compared");
  command->callback([options, shard, &exit_code] {
    if (!shard->empty()) options->shard = shard_of(*shard);
    const bool is_joined = !options->merged.empty();
    if ((is_joined || options->shard.count > 1) && options->directory.empty()) {
      throw std::invalid_argument(is_joined ? "--merge needs -o DIR" : "--shard needs -o DIR");
    }
    if (options->one_a_core && !is_started_with_others()) {
      throw std::invalid_argument("--one-a-core: only for processes that mpirun starts");
    }
    if (is_joined) {
      exit_code = merge_studies(options->merged, options->directory, options->format);
    } else {
      compare_solvers(*options);
    }
  });
}

}  // namespace wavecurve::tools
