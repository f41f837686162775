#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "benchmarks/tracking/backfill.hpp"
#include "benchmarks/tracking/compare.hpp"
#include "benchmarks/tracking/make_record.hpp"
#include "benchmarks/tracking/self_testing.hpp"
#include "tools/commands/clone.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/input/number_option.hpp"
#include "tools/commands/progress.hpp"
#include "tools/commands/terminal.hpp"

namespace wavecurve::tools {

namespace {

namespace fs = std::filesystem;
using namespace tracking;

/// One line that is written over and over where someone watches; else one a step.
void stop_saying() { say(""); }

/// A record, a folder with programs, or a revision; "." is the working tree.
Side side_of(const std::string& name, Programs programs) {
  const fs::path path = name;
  std::error_code ignored;  // a path that leads nowhere is a name
  if (path.extension() == ".json" && fs::is_regular_file(path, ignored)) {
    return {name, {}, read_record(path)};
  }
  if (name != "." && fs::is_directory(path, ignored)) return {name, build_in(path), {}};
  say("building " + (name == "." ? "the working tree" : name));
  Build build = build_revision(clone(), name == "." ? "" : name, programs);
  return {build.name + " (" + build.revision.at("commit").get<std::string>().substr(0, 10) + ")",
          build,
          {}};
}

struct RecordArguments {
  std::string revision = ".";
  RecordOptions options;
  bool only_counts = false, only_kernels = false;
  fs::path history;
};

void run_record(RecordArguments arguments) {
  const Programs programs =
      arguments.only_counts || arguments.only_kernels ? Programs::kernels : Programs::all;
  const Side side = side_of(arguments.revision, programs);
  if (!side.build) throw std::invalid_argument("'" + arguments.revision + "' is a record already");
  arguments.options.is_timed = !arguments.only_counts;
  const Json record = make_record(*side.build, arguments.options, say);
  const fs::path path =
      append_record(given_or_of_clone(arguments.history, "benchmarks/history"), record);
  stop_saying();
  print_text(fmt::format("recorded {}: {} marked kernels, {} benchmarks, in {}\n",
                         printable(side.name), record.value("kernels", Json::object()).size(),
                         record.value("benchmarks", Json::array()).size(),
                         printable(path.string())));
}

void add_record(CLI::App& bench) {
  auto arguments = std::make_shared<RecordArguments>();
  CLI::App* command =
      bench.add_subcommand("record", "Measure a revision and add the record to the history");
  command
      ->add_option("revision", arguments->revision,
                   "A revision, or a folder with programs; . is the working tree")
      ->capture_default_str();
  CLI::Option* filter =
      command->add_option("--filter", arguments->options.filter,
                          "Time only benchmarks that match this regular expression");
  CLI::Option* repetitions = command->add_option("--repetitions", arguments->options.repetitions,
                                                 "Repetitions per benchmark");
  repetitions->check(whole_number_from(1, 1000))->capture_default_str();
  CLI::Option* only_kernels = command->add_flag("--only-kernels", arguments->only_kernels,
                                                "Time the marked kernels, not the other programs");
  command->add_flag("--only-counts", arguments->only_counts, "Count instructions, time nothing")
      ->excludes(filter, repetitions, only_kernels);
  command
      ->add_option("--history", arguments->history,
                   "Folder of the records; by default benchmarks/history of the clone")
      ->type_name("DIR");
  command->callback([arguments] { run_record(*arguments); });
}

struct BackfillArguments {
  long count = 20;
  bool is_timed = false;
  fs::path history;
};

void run_backfill(const BackfillArguments& arguments) {
  const fs::path history = given_or_of_clone(arguments.history, "benchmarks/history");
  RecordOptions options;
  options.is_timed = options.has_limits = arguments.is_timed;
  std::size_t recorded = 0, skipped = 0;
  for (const std::string& revision :
       revisions_to_record(clone(), history, static_cast<std::size_t>(arguments.count))) {
    try {
      const Side side = side_of(revision, Programs::kernels);
      append_record(history, make_record(*side.build, options, say));
      ++recorded;
      stop_saying();
      print_text(fmt::format("recorded {} {}\n", revision.substr(0, 10),
                             printable(side.build->revision.at("subject").get<std::string>())));
    } catch (const std::runtime_error& error) {
      ++skipped;
      stop_saying();
      print_message(fmt::format("skipped {}: {}", revision.substr(0, 10), error.what()));
    }
    std::fflush(stdout);
  }
  print_text(fmt::format("{} recorded, {} skipped\n", recorded, skipped));
}

void add_backfill(CLI::App& bench) {
  auto arguments = std::make_shared<BackfillArguments>();
  CLI::App* command = bench.add_subcommand(
      "backfill",
      "Add records of past revisions to the history: of those that changed the library or the "
      "benchmarks, evenly spaced. What does not build is skipped, and named");
  command->add_option("--count", arguments->count, "How many revisions at most")
      ->check(whole_number_from(1, 10000))
      ->capture_default_str();
  command->add_flag("--times", arguments->is_timed, "Also time the marked kernels");
  command
      ->add_option("--history", arguments->history,
                   "Folder of the records; by default benchmarks/history of the clone")
      ->type_name("DIR");
  command->callback([arguments] { run_backfill(*arguments); });
}

struct CompareArguments {
  std::string a, b = ".";
  CompareOptions options;
  bool all = false, only_counts = false;
  fs::path json, markdown;
};

ExitCode run_compare(CompareArguments arguments) {
  const Programs programs = arguments.options.filter.empty() ? Programs::kernels : Programs::all;
  arguments.options.is_timed = !arguments.only_counts;
  const Side a = side_of(arguments.a, programs), b = side_of(arguments.b, programs);
  const Comparison comparison = compare(a, b, arguments.options, say);
  stop_saying();
  print_text(to_text(comparison, arguments.all));
  if (!arguments.json.empty())
    io::write_file(arguments.json, io::json_text(to_json(comparison), 1) + "\n");
  if (!arguments.markdown.empty()) io::write_file(arguments.markdown, to_markdown(comparison));
  return static_cast<ExitCode>(comparison.exit_code());
}

void add_compare(CLI::App& bench, ExitCode& exit_code) {
  auto arguments = std::make_shared<CompareArguments>();
  CompareOptions& options = arguments->options;
  CLI::App* command = bench.add_subcommand(
      "compare",
      "Compare two revisions, records or builds by instructions, accuracy and times. Exit codes: 0 no "
      "regression, 1 regression, 4 inconclusive, 5 different machines");
  command->add_option("before", arguments->a, "A revision, a record, or a folder with programs")
      ->required();
  command->add_option("after", arguments->b, "The same; . is the working tree")
      ->capture_default_str();
  CLI::Option* filter =
      command->add_option("--filter", options.filter,
                          "Time the benchmarks of all programs that match this regular expression; "
                          "the marked kernels if not given");
  CLI::Option* blocks =
      command->add_option("--blocks", options.blocks, "Blocks A B B A per benchmark");
  blocks->check(whole_number_from(6, 1000))->capture_default_str();
  CLI::Option* threshold = command->add_option("--threshold", options.thresholds.time,
                                               "Smallest relative change of time that counts");
  threshold->check(number_from(0, 1))->capture_default_str();
  CLI::Option* seed = command->add_option("--seed", options.seed, "Random seed for the order");
  seed->check(whole_number_from(0, std::numeric_limits<long>::max()))->capture_default_str();
  command->add_flag("--only-counts", arguments->only_counts, "Count instructions, time nothing")
      ->excludes(filter, blocks, threshold, seed);
  command->add_flag("--all", arguments->all, "Also show what is unchanged");
  command->add_flag("--force", options.is_forced, "Compare records of different machines");
  command->add_option("--json", arguments->json, "Write the comparison as JSON")->type_name("FILE");
  command->add_option("--markdown", arguments->markdown, "Write it for a pull request")
      ->type_name("FILE");
  command->callback([arguments, &exit_code] {
    try {
      exit_code = run_compare(*arguments);
    } catch (const MachinesDiffer& error) {
      stop_saying();
      print_message(error.what());
      exit_code = machines_differ;
    }
  });
}

Build given_build(const fs::path& folder) {
  return build_in(given_or_of_clone(folder, "build/release/bin"));
}

ExitCode run_self_test(const fs::path& build, bool is_short) {
  bool is_passed = true;
  for (const Check& check : self_test(given_build(build), is_short, say)) {
    stop_saying();
    fmt::print("{}  {}\n        {}\n", check.is_passed ? "ok    " : "FAILED", check.what,
               check.found);
    is_passed = is_passed && check.is_passed;
  }
  return is_passed ? done : differs;
}

void add_self_test(CLI::App& bench, ExitCode& exit_code) {
  auto build = std::make_shared<fs::path>();
  auto is_short = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand(
      "self-test", "Try whether the tracking is silent where nothing changed, and finds what did");
  command->add_option(
      "build", *build,
      "Folder with kernel_benchmark and its slowed copies; build/release/bin of the clone if "
      "not given");
  command->add_flag("--short", *is_short, "Within two minutes: fewer kernels, fewer blocks");
  command->callback([=, &exit_code] { exit_code = run_self_test(*build, *is_short); });
}

struct CheckArguments {
  fs::path build, baseline;
  bool bless = false, all = false;
};

/// Nothing of the machine that it was made on but what counts depend on.
void bless(const CheckArguments& arguments) {
  Json record = {
      {"schema", record_schema}, {"date", date_now()}, {"revision", {{"commit", "build"}}}};
  record.update(measure_counts(given_build(arguments.build)));
  if (!record.contains("kernels")) {
    throw std::runtime_error("nothing to bless: valgrind does not run here");
  }
  fs::create_directories(arguments.baseline.parent_path());
  io::write_file(arguments.baseline, io::json_text(record, 1) + "\n");
  stop_saying();
  fmt::print("blessed: {}\n", printable(arguments.baseline.string()));
}

ExitCode run_check(const CheckArguments& arguments) {
  CompareOptions options;
  options.is_timed = false;
  const Side baseline{"the blessed record", {}, read_record(arguments.baseline)};
  const Side now{"this build", given_build(arguments.build), {}};
  try {
    const Comparison comparison = compare(baseline, now, options, say);
    stop_saying();
    print_text(to_text(comparison, arguments.all));
    if (comparison.exit_code() == 1) {
      fmt::print("if this is wanted: tools/bench.sh check --bless\n");
    }
    return static_cast<ExitCode>(comparison.exit_code());
  } catch (const MachinesDiffer& reason) {
    stop_saying();
    fmt::print("instruction counts not checked, {}\n", printable(reason.what()));
    return done;
  }
}

void add_check(CLI::App& bench, ExitCode& exit_code) {
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = bench.add_subcommand(
      "check", "Compare instruction counts and accuracy of a build with the blessed record");
  command->add_option("build", arguments->build,
                      "Folder with kernel_benchmark; by default build/release/bin of the clone");
  command
      ->add_option("--baseline", arguments->baseline,
                   "The blessed record; by default benchmarks/baseline/counts.json of the clone")
      ->type_name("FILE");
  command->add_flag("--bless", arguments->bless, "Make this build's record the blessed one");
  command->add_flag("--all", arguments->all, "Also show what is unchanged")
      ->excludes(command->get_option("--bless"));
  command->callback([arguments, &exit_code] {
    arguments->baseline = given_or_of_clone(arguments->baseline, "benchmarks/baseline/counts.json");
    if (arguments->bless) {
      bless(*arguments);
    } else {
      exit_code = run_check(*arguments);
    }
  });
}

}  // namespace

void add_bench_command(CLI::App& app, ExitCode& exit_code) {
  CLI::App* bench = app.add_subcommand(
      "bench", "Track performance and accuracy (docs/how-to-read-benchmarks.md)");
  bench->require_subcommand(1);
  add_record(*bench);
  add_backfill(*bench);
  add_compare(*bench, exit_code);
  add_self_test(*bench, exit_code);
  add_check(*bench, exit_code);
}

}  // namespace wavecurve::tools
