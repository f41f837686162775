#include "benchmarks/tracking/self_testing.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "benchmarks/tracking/compare.hpp"
#include "benchmarks/tracking/growth.hpp"
#include "benchmarks/tracking/instruction_counts.hpp"
#include "benchmarks/tracking/make_record.hpp"
#include "benchmarks/tracking/marked_kernels.hpp"

namespace wavecurve::tracking {

namespace {

const std::string slowed_kernel = "transform_forward";

Build slowed(const Build& build, int runs) {
  return build_in(build.programs / fmt::format("slowed_{}", runs));
}

std::string percent(double ratio) { return fmt::format("{:+.2f} %", 100 * (ratio - 1)); }

Comparison by_counts(const Json& before, const Json& after) {
  CompareOptions options;
  options.is_timed = false;
  return compare({"", {}, before}, {"", {}, after}, options, [](const auto&) {});
}

Check counts_silent(const Json& counts, const Build& build) {
  const Comparison again = by_counts(counts, measure_counts(build, 1));
  double worst = 1;
  for (const Row& row : again.rows) {
    if (std::abs(row.ratio.ratio - 1) > std::abs(worst - 1)) worst = row.ratio.ratio;
  }
  return {"counts and accuracy of a build against itself: nothing found",
          fmt::format("largest relative difference {:.1g}", std::abs(worst - 1)),
          again.exit_code() == 0};
}

Check counts_find(const Json& counts, const Build& build, int runs) {
  const Comparison found = by_counts(counts, measure_counts(slowed(build, runs), 1));
  std::string text;
  bool is_passed = false;
  for (const Row& row : found.rows) {
    if (row.verdict == Change::same) continue;
    const bool is_it = row.benchmark.starts_with(slowed_kernel + "/");
    is_passed = text.empty() && is_it && row.verdict == Change::slower;
    text +=
        fmt::format("{} {} {} ", row.benchmark, to_string(row.verdict), percent(row.ratio.ratio));
  }
  return {fmt::format("{} slowed in one of {} runs: found by counts, and nothing else",
                      slowed_kernel, runs),
          text.empty() ? "nothing" : text, is_passed};
}

Check accuracy_finds(const Json& counts) {
  Json worse = counts;
  Json& error = worse["accuracy"]["round_trip_db4"]["value"];
  error = 1.2 * error.get<double>();
  return {"an error 20 % larger: found", "round_trip_db4",
          by_counts(counts, worse).exit_code() == 1};
}

/// The kernels that are timed: in the short form two of the shortest.
std::vector<BenchmarkName> timed_kernels(const Build& build, bool is_short) {
  std::vector<BenchmarkName> names;
  for (const MarkedKernel& kernel : marked_kernels(build)) {
    const bool is_chosen =
        !is_short || kernel.name == slowed_kernel || kernel.name == "operator_product";
    if (kernel.is_plain || !is_chosen) continue;
    names.push_back({"kernel_benchmark", kernel.name + "/" + std::to_string(kernel.size)});
  }
  return names;
}

CompareOptions timing_options(bool is_short) {
  CompareOptions options;
  if (is_short) {
    options.blocks = 6;
    options.seconds = 0.004;
  }
  return options;
}

Check times_silent(const Build& build, bool is_short, const Say& say) {
  constexpr int rounds = 50;
  const auto names = timed_kernels(build, is_short);
  CompareOptions options = timing_options(is_short);
  int alarms = 0, same = 0, rows = 0;
  for (int round = 0; round < rounds; ++round) {
    say(fmt::format("a build against itself, round {} of {}, {} false alarms", round + 1, rounds,
                    alarms));
    options.seed = static_cast<std::uint64_t>(2 * round);
    const auto result = compare_times(build, build, names, options, [](const auto&) {});
    alarms += std::ranges::any_of(result, is_alarm) ? 1 : 0;
    rows += static_cast<int>(result.size());
    same += static_cast<int>(std::ranges::count(result, Change::same, &Row::verdict));
  }
  return {fmt::format("times of a build against itself, {} rounds of {} kernels: at most one alarm",
                      rounds, names.size()),
          fmt::format("{} false alarms; {} of {} verdicts same, the others inconclusive", alarms,
                      same, rows),
          alarms <= 1};
}

/// Whether the slowed kernel alone is found, and what is.
std::pair<bool, std::string> find_by_times(const Build& build, const CompareOptions& options,
                                           const std::vector<BenchmarkName>& names,
                                           const Say& say) {
  std::string text;
  bool is_found = false, is_other = false;
  for (const Row& row : compare_times(build, slowed(build, 5), names, options, say)) {
    if (!is_alarm(row)) continue;
    text +=
        fmt::format("{} {} {} ", row.benchmark, to_string(row.verdict), percent(row.ratio.ratio));
    const bool is_it = row.benchmark.starts_with(slowed_kernel + "/");
    (is_it && row.verdict == Change::slower ? is_found : is_other) = true;
  }
  return {is_found && !is_other, text.empty() ? "nothing" : text};
}

/// Noise can hide a change of 20 % from one comparison in six (bootstrap_test.cpp), so there are
/// three attempts: all fail in one of 200.
Check times_find(const Build& build, bool is_short, const Say& say) {
  say("a kernel slowed by 20 %");
  const auto names = timed_kernels(build, is_short);
  CompareOptions options = timing_options(is_short);
  options.blocks = 12;
  Check check{slowed_kernel + " slowed by 20 %: found by times, and nothing else", "", false};
  for (int attempt = 1; attempt <= 3 && !check.is_passed; ++attempt) {
    options.seed += 2;
    const auto [is_found, text] = find_by_times(build, options, names, say);
    check.is_passed = is_found;
    check.found += fmt::format("{}attempt {}: {}", attempt > 1 ? "; " : "", attempt, text);
  }
  return check;
}

/// All sizes of all kernels that state a growth are counted by one process.
std::vector<Check> growths(const Build& build, const Say& say) {
  say("growth of the kernels");
  std::vector<CountedKernel> counted;
  const std::vector<MarkedKernel> kernels = marked_kernels(build);
  for (const MarkedKernel& kernel : kernels) {
    for (const long size : kernel.sizes) counted.push_back({kernel.name, size});
  }
  const std::vector<Counts> counts = count_instructions(build.kernel_program(), counted, 1);
  std::vector<Check> checks;
  std::size_t next = 0;
  for (const MarkedKernel& kernel : kernels) {
    std::vector<double> sizes, costs;
    for (std::size_t i = 0; i < kernel.sizes.size(); ++i, ++next) {
      sizes.push_back(static_cast<double>(counted[next].size));
      costs.push_back(counts[next].instructions);
    }
    if (sizes.empty()) continue;
    const GrowthFit fit = fit_growth(sizes, costs, kernel.growth);
    checks.push_back({fmt::format("growth of {}: {} {}", kernel.name,
                                  kernel.is_plain ? "found to be above" : "at most", kernel.growth),
                      fmt::format("({})^{:.3f}, {:.3f} .. {:.3f}", kernel.growth, fit.exponent,
                                  fit.lower, fit.upper),
                      fit.exceeds_stated() == kernel.is_plain});
  }
  return checks;
}

}  // namespace

std::vector<Check> self_test(const Build& build, bool is_short, const Say& say) {
  if (!build.has_kernels()) {
    throw std::invalid_argument("'" + build.name + "': no kernel_benchmark there");
  }
  std::vector<Check> checks;
  say("counting instructions");
  const Json counts = measure_counts(build, 1);
  if (counts.contains("kernels")) {
    checks.push_back(counts_silent(counts, build));
    for (const int runs : {20, 100}) checks.push_back(counts_find(counts, build, runs));
    const auto growth_checks = growths(build, say);
    checks.insert(checks.end(), growth_checks.begin(), growth_checks.end());
  } else {
    checks.push_back({"instruction counts", "left out: valgrind does not run here", true});
  }
  checks.push_back(accuracy_finds(counts));
  checks.push_back(times_find(build, is_short, say));
  checks.push_back(times_silent(build, is_short, say));
  return checks;
}

}  // namespace wavecurve::tracking
