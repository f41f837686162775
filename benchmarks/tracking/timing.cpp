#include "benchmarks/tracking/timing.hpp"

#include <algorithm>
#include <cctype>
#include <random>
#include <regex>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/json_place.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/io/files/detail/run_program.hpp"
#include "wavecurve/io/files/detail/temporary.hpp"
#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve::tracking {

namespace {

namespace fs = std::filesystem;
using Place = io::OrderedJsonPlace;

/// The spread of a counter that is always 0 is written as NaN, and there may be infinities, which JSON
/// does not have: they become null. By hand, for std::regex recurses over what it matches.
std::string with_nulls(std::string_view text) {
  constexpr std::string_view key_end = ": ";
  std::string result;
  while (!text.empty()) {
    const std::size_t value = std::min(text.find(key_end), text.size() - 1);
    std::string_view word = text.substr(std::min(value + key_end.size(), text.size()));
    if (word.starts_with('-')) word.remove_prefix(1);
    const auto starts_with = [&](std::string_view lower) {
      return word.size() >= lower.size() &&
             std::equal(lower.begin(), lower.end(), word.begin(), [](char a, char b) {
               return a == std::tolower(static_cast<unsigned char>(b));
             });
    };
    if (starts_with("nan") || starts_with("inf")) {
      result.append(text.substr(0, value)).append(": null");
      while (!word.empty() && std::isalpha(static_cast<unsigned char>(word.front())))
        word.remove_prefix(1);
      text = word;
    } else {
      const std::size_t taken = std::min(value + key_end.size(), text.size());
      result.append(text.substr(0, taken));
      text.remove_prefix(taken);
    }
  }
  return result;
}

/// The name as a regular expression that matches nothing else.
std::string escaped(const std::string& name) {
  std::string pattern = "^";
  for (const char c : name) {
    if (std::string_view("^$.*+?()[]{}|\\").find(c) != std::string_view::npos) pattern += '\\';
    pattern += c;
  }
  return pattern + "$";
}

/// Seconds, of all repetitions of a benchmark; a longer one is not what is tracked.
constexpr int longest = 20;

/// Reads what the program writes into a file, for some print tables of their own. What it throws
/// names the program, not its folder: the text is kept in records, which know no machine's paths.
Json run_with_output(const fs::path& program, std::vector<std::string> arguments) {
  const std::string name = program.filename().string();
  const io::Temporary file(fs::temp_directory_path() / "times", io::Temporary::Kind::file);
  arguments.insert(arguments.begin(), {"timeout", std::to_string(longest), program.string()});
  arguments.push_back("--benchmark_out=" + file.path().string());
  arguments.emplace_back("--benchmark_out_format=json");
  const io::ProgramRun run = io::run_program(arguments);
  const std::string text = with_nulls(io::read_file(file.path()));
  if (run.exit_code == 124) {
    throw std::runtime_error(fmt::format("{} took more than {} s", name, longest));
  }
  if (run.exit_code != 0) {
    throw std::runtime_error(
        fmt::format("{} {} ended with {}: {}", name, arguments[3], run.exit_code, run.err));
  }
  return io::parse_ordered_json(text);
}

std::regex regular_expression(const std::string& text) {
  try {
    return std::regex(text);
  } catch (const std::regex_error&) {
    throw std::invalid_argument("the filter '" + text.substr(0, 60) + "' is no regular expression");
  }
}

}  // namespace

double seconds_of_unit(const std::string& unit) {
  if (unit == "ns") return 1e-9;
  if (unit == "us") return 1e-6;
  return unit == "ms" ? 1e-3 : 1;
}

std::vector<BenchmarkName> list_benchmarks(const fs::path& program, const std::string& filter) {
  constexpr std::size_t longest_name = 300;  // std::regex recurses over what it matches
  const std::regex wanted = regular_expression(filter);
  std::vector<BenchmarkName> names;
  std::istringstream lines(io::output_of({program.string(), "--benchmark_list_tests"}));
  for (std::string line; std::getline(lines, line);) {
    // Lines with blanks are a program's own.
    const bool is_name =
        !line.empty() && line.size() <= longest_name && line.find(' ') == std::string::npos;
    if (is_name && std::regex_search(line, wanted)) {
      names.push_back({program.filename().string(), line});
    }
  }
  return names;
}

Json run_benchmark(const fs::path& program, const std::string& name, double seconds,
                   int repetitions) {
  // Names that are listed may end in /iterations:1 or /repeats:9, and are matched whole.
  const Json all = run_with_output(program, {"--benchmark_filter=" + escaped(name),
                                             fmt::format("--benchmark_min_time={}", seconds),
                                             fmt::format("--benchmark_repetitions={}", repetitions),
                                             "--benchmark_report_aggregates_only=false"});
  Json runs = Json::array();
  for (const Place& run : Place(all).at("benchmarks").elements()) {
    const auto failed = run.find("error_occurred");
    if (failed && failed->value() == true) {
      throw std::runtime_error(name + ": " + run.at("error_message").text());
    }
    const auto type = run.find("run_type");
    if (type && type->text() != "iteration") continue;
    run.at("time_unit").text();
    for (const char* key : {"real_time", "cpu_time", "iterations"}) run.at(key).number();
    runs.push_back(run.value());
  }
  if (runs.empty())
    throw std::runtime_error(program.filename().string() + " has no benchmark " + name);
  return runs;
}

double time_once(const fs::path& program, const std::string& name, double seconds) {
  constexpr int repetitions = 5;
  double least = std::numeric_limits<double>::infinity();
  for (const Json& run : run_benchmark(program, name, seconds / repetitions, repetitions)) {
    least = std::min(least, run.at("cpu_time").get<double>() *
                                seconds_of_unit(run.at("time_unit").get<std::string>()));
  }
  return least;
}

std::vector<std::vector<Block>> time_interleaved(const std::vector<TimedPair>& pairs, int blocks,
                                                 std::uint64_t seed, const Say& say) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<Block>> times(pairs.size());
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int round = 0; round < blocks; ++round) {
    std::ranges::shuffle(order, random);
    for (const std::size_t i : order) {
      const TimedPair& pair = pairs[i];
      say(fmt::format("timing, block {} of {}: {}", round + 1, blocks, pair.name));
      Block block{};
      if (random() % 2 == 0) {
        block.a_first = pair.a();
        block.b_first = pair.b();
        block.b_second = pair.b();
        block.a_second = pair.a();
      } else {
        block.b_first = pair.b();
        block.a_first = pair.a();
        block.a_second = pair.a();
        block.b_second = pair.b();
      }
      times[i].push_back(block);
    }
  }
  return times;
}

std::map<BenchmarkName, std::vector<Block>> time_interleaved(
    const fs::path& a, const fs::path& b, const std::vector<BenchmarkName>& benchmarks, int blocks,
    double seconds, std::uint64_t seed, const Say& say) {
  std::vector<TimedPair> pairs;
  for (const BenchmarkName& benchmark : benchmarks) {
    const auto timer = [&](const fs::path& folder) {
      return [program = folder / benchmark.program, name = benchmark.name, seconds] {
        return time_once(program, name, seconds);
      };
    };
    pairs.push_back({benchmark.name, timer(a), timer(b)});
  }
  const auto times = time_interleaved(pairs, blocks, seed, say);
  std::map<BenchmarkName, std::vector<Block>> result;
  for (std::size_t i = 0; i < benchmarks.size(); ++i) result[benchmarks[i]] = times[i];
  return result;
}

}  // namespace wavecurve::tracking
