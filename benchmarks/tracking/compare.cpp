#include "benchmarks/tracking/compare.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "wavecurve/io/files/read_file.hpp"

#include "benchmarks/tracking/machine_fingerprint.hpp"
#include "benchmarks/tracking/make_record.hpp"
#include "benchmarks/tracking/marked_kernels.hpp"

namespace wavecurve::tracking {

namespace {

namespace fs = std::filesystem;

/// Flags and compiler of two builds are part of what is compared; a record must be of this machine.
void check_machines(const Side& a, const Side& b, const Json& before, const Json& after,
                    const CompareOptions& options, std::vector<std::string>& notes) {
  const auto part = [&](const Json& from) {
    Json json = {{"environment", from.value("environment", Json::object())},
                 {"valgrind", from.value("valgrind", Json::object())}};
    if (options.is_timed) json["machine"] = from.value("machine", Json::object());
    return json;
  };
  std::string refused;
  for (const std::string& difference : differences(part(before), part(after))) {
    notes.push_back("differs: " + difference);
    // The project chooses its flags itself.
    const bool is_own = difference.starts_with("environment/flags");
    // Counts are taken on valgrind's processor, and results are the same on all.
    const bool is_for_times = difference.starts_with("environment/vectors");
    if (!is_own && (options.is_timed || !is_for_times))
      refused += (refused.empty() ? "" : "; ") + difference;
  }
  if ((a.build && b.build) || refused.empty() || options.is_forced) return;
  throw MachinesDiffer("not the same machine (--force compares all the same): " + refused);
}

void compare_counts(const Json& before, const Json& after, const CompareOptions& options,
                    Comparison& result) {
  const Json none = Json::object();
  const Json a = before.value("kernels", none), b = after.value("kernels", none);
  for (const auto& [name, old] : a.items()) {
    const auto found = b.find(name);
    if (found == b.end() || found->at("size") != old.at("size")) {
      result.notes.push_back("kernel " + name + " is only in one of the two");
      continue;
    }
    const auto references = [](const Json& c) {
      return c.at("data_reads").get<double>() + c.at("data_writes").get<double>();
    };
    Row row{name + "/" + old.at("size").dump(), "instructions",
            old.at("instructions").get<double>(), found->at("instructions").get<double>()};
    row.ratio = {row.after / row.before, row.after / row.before, row.after / row.before};
    row.verdict = judge_count(row.before, row.after, options.thresholds.count);
    row.note = fmt::format("data references {:.4f}", references(*found) / references(old));
    result.rows.push_back(row);
  }
}

double loss(const std::string& kind, double before, double after) {
  if (before == after) return 1;
  return kind == "digits" ? std::pow(10, before - after) : after / before;
}

void compare_accuracy(const Json& before, const Json& after, const CompareOptions& options,
                      Comparison& result) {
  const Json none = Json::object();
  const Json a = before.value("accuracy", none), b = after.value("accuracy", none);
  for (const auto& [name, old] : a.items()) {
    const auto found = b.find(name);
    if (found == b.end()) continue;
    const auto kind = old.at("kind").get<std::string>();
    // What is no number is null in JSON.
    const auto value = [](const Json& entry) {
      return entry.at("value").is_number() ? entry.at("value").get<double>() : std::nan("");
    };
    Row row{"accuracy " + name, kind, value(old), value(*found)};
    const double ratio = loss(kind, row.before, row.after);
    row.ratio = {ratio, ratio, ratio};
    row.verdict = judge_accuracy(kind, row.before, row.after, options.thresholds);
    result.rows.push_back(row);
  }
}

/// The median of a program's times in all blocks.
double typical(const std::vector<Block>& blocks, double Block::*first, double Block::*second) {
  std::vector<double> times;
  for (const Block& block : blocks) {
    times.push_back(block.*first);
    times.push_back(block.*second);
  }
  return median(std::move(times));
}

Row time_row(const BenchmarkName& benchmark, const std::vector<Block>& blocks,
             const CompareOptions& options) {
  Row row{benchmark.name, "time", typical(blocks, &Block::a_first, &Block::a_second),
          typical(blocks, &Block::b_first, &Block::b_second)};
  row.ratio = bootstrap_ratio(blocks);
  row.verdict = judge_time(row.ratio, options.thresholds.time);
  return row;
}

/// The second measurement decides; where it does not say the same the first was no more than noise.
void confirm(Row& row, const Row& again) {
  const bool is_confirmed = row.verdict == again.verdict;
  row.note = fmt::format("{} by a second measurement: {:.3f}, {:.3f} .. {:.3f}",
                         is_confirmed ? "confirmed" : "not confirmed", again.ratio.ratio,
                         again.ratio.lower, again.ratio.upper);
  if (!is_confirmed) {
    row.verdict = again.verdict == Change::same ? Change::same : Change::inconclusive;
  }
}

bool is_identical(const fs::path& a, const fs::path& b) {
  return fs::file_size(a) == fs::file_size(b) && io::read_file(a) == io::read_file(b);
}

/// kernel/size of the marked kernels, each at its tracked size.
std::vector<BenchmarkName> marked(const Build& build) {
  std::vector<BenchmarkName> names;
  if (!build.has_kernels()) return names;
  for (const MarkedKernel& kernel : marked_kernels(build)) {
    if (kernel.is_plain) continue;
    names.push_back({"kernel_benchmark", kernel.name + "/" + std::to_string(kernel.size)});
  }
  return names;
}

std::vector<BenchmarkName> chosen(const Build& build, const CompareOptions& options) {
  if (options.filter.empty()) return marked(build);
  std::vector<BenchmarkName> all;
  for (const fs::path& program : build.all_programs()) {
    const auto names = list_benchmarks(program, options.filter);
    all.insert(all.end(), names.begin(), names.end());
  }
  return all;
}

/// Those of both, without the programs that are the same.
std::vector<BenchmarkName> to_be_timed(const Build& a, const Build& b,
                                       const CompareOptions& options,
                                       std::vector<std::string>& notes) {
  const std::vector<BenchmarkName> others = chosen(b, options);
  const std::set<BenchmarkName> in_b(others.begin(), others.end());
  std::vector<BenchmarkName> common;
  std::set<std::string> identical;
  for (const BenchmarkName& name : chosen(a, options)) {
    if (!in_b.contains(name)) {
      notes.push_back("benchmark " + name.name + " is only in one of the two");
    } else if (options.skip_identical && !identical.contains(name.program) &&
               is_identical(a.programs / name.program, b.programs / name.program)) {
      identical.insert(name.program);
      notes.push_back(name.program + " is the same program, byte for byte: not timed");
    }
    if (in_b.contains(name) && !identical.contains(name.program)) common.push_back(name);
  }
  return common;
}

std::map<std::string, std::vector<double>> recorded_times(const Json& record) {
  std::map<std::string, std::vector<double>> times;
  for (const Json& entry : record.value("benchmarks", Json::array())) {
    if (!entry.contains("cpu_time")) continue;
    const double scale = seconds_of_unit(entry.at("time_unit").get<std::string>());
    for (const Json& time : entry.at("cpu_time")) {
      times[entry.at("name").get<std::string>()].push_back(time.get<double>() * scale);
    }
  }
  return times;
}

void show_recorded_times(const Json& before, const Json& after, const CompareOptions& options,
                         Comparison& result) {
  const auto a = recorded_times(before), b = recorded_times(after);
  for (const auto& [name, times] : a) {
    if (!b.contains(name)) continue;
    Row row{name, "time", median(times), median(b.at(name))};
    row.ratio = bootstrap_ratio(times, b.at(name));
    row.verdict = judge_time(row.ratio, options.thresholds.time);
    if (row.verdict != Change::same) row.verdict = Change::inconclusive;
    row.note = "not measured together";
    result.rows.push_back(row);
  }
}

Json document_of(const Side& side, const Say& say) {
  if (!side.build) return side.record;
  say("counting instructions of " + side.name);
  Json json = measure_counts(*side.build);
  json["machine"] = machine_fingerprint();
  return json;
}

}  // namespace

std::vector<Row> compare_times(const Build& a, const Build& b,
                               const std::vector<BenchmarkName>& benchmarks,
                               const CompareOptions& options, const Say& say) {
  const auto measure = [&](const std::vector<BenchmarkName>& list, std::uint64_t seed) {
    return time_interleaved(a.programs, b.programs, list, options.blocks, options.seconds, seed,
                            say);
  };
  std::vector<BenchmarkName> alarms;
  std::map<BenchmarkName, Row> rows;
  for (const auto& [name, blocks] : measure(benchmarks, options.seed)) {
    rows[name] = time_row(name, blocks, options);
    if (is_alarm(rows[name])) alarms.push_back(name);
  }
  if (!alarms.empty()) {
    say(fmt::format("measuring {} once more", alarms.size()));
    for (const auto& [name, blocks] : measure(alarms, options.seed + 1)) {
      confirm(rows[name], time_row(name, blocks, options));
    }
  }
  std::vector<Row> result;
  for (const BenchmarkName& name : benchmarks) result.push_back(rows[name]);
  return result;
}

Comparison compare(const Side& a, const Side& b, const CompareOptions& options, const Say& say) {
  Comparison result{a.name, b.name, {}, {}};
  const bool are_builds = a.build && b.build;
  if (are_builds && options.skip_identical && a.build->has_kernels() && b.build->has_kernels() &&
      is_identical(a.build->kernel_program(), b.build->kernel_program())) {
    result.notes.emplace_back(
        "kernel_benchmark is the same program, byte for byte: neither counted nor timed");
    if (options.filter.empty()) return result;
  } else {
    const Json before = document_of(a, say), after = document_of(b, say);
    check_machines(a, b, before, after, options, result.notes);
    compare_counts(before, after, options, result);
    compare_accuracy(before, after, options, result);
    if (options.is_timed && !are_builds) show_recorded_times(before, after, options, result);
  }
  if (options.is_timed && are_builds) {
    const auto benchmarks = to_be_timed(*a.build, *b.build, options, result.notes);
    const auto rows = compare_times(*a.build, *b.build, benchmarks, options, say);
    result.rows.insert(result.rows.end(), rows.begin(), rows.end());
  }
  return result;
}

}  // namespace wavecurve::tracking
