#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/io/load_filter.hpp"
#include "wavecurve/io/write_file.hpp"

#include "commands.hpp"
#include "named_shapes.hpp"
#include "number_format.hpp"
#include "progress.hpp"
#include "solver_study.hpp"

namespace wavecurve::tools {

namespace {

using verification::StudyPoint;

struct Options {
  std::string filter = "db4", shape = "ellipse", format = "text", directory;
  long samples = 64;
  int levels = -1;  ///< -1: all
  std::vector<double> damping = {0, 0};
  std::vector<std::string> solvers;  ///< empty: all that solve the equation with mass
};

Options completed(Options options) {
  check_samples(options.samples);
  if (options.levels < 0) options.levels = verification::all_levels(options.samples);
  if (!options.solvers.empty()) return options;
  for (const NamedSolver& solver : solvers()) {
    if (!solver.is_massless) options.solvers.push_back(solver.name);
  }
  return options;
}

std::vector<StudyPoint> points_of(const Options& options) {
  Material material;
  material.mass_damping = options.damping[0];
  material.stiffness_damping = options.damping[1];
  const verification::Study study{
      {io::load_filter_bank(options.filter), options.samples, options.levels, material},
      verification::shape_of(options.shape, options.samples),
      options.solvers};
  Progress progress("solvers");
  return verification::run_study(
      study, [&](std::size_t done, std::size_t all) { progress.show(done, all); });
}

nlohmann::ordered_json point_json(const Options& options, const StudyPoint& point) {
  nlohmann::ordered_json json = {{"solver", point.solver},     {"filter", options.filter},
                                 {"samples", options.samples}, {"levels", options.levels},
                                 {"shape", options.shape},     {"damping", options.damping}};
  json["tolerance"] = nullptr;
  if (point.tolerance) json["tolerance"] = *point.tolerance;
  json["error"] = nullptr;
  json["cost"] = nullptr;
  if (point.errors) {
    json["error"] = {{"displacement_l2_max", point.errors->displacement_l2_max},
                     {"displacement_l2_final", point.errors->displacement_l2_final},
                     {"energy_norm_max", point.errors->energy_norm_max}};
    json["cost"] = {{"evaluations", point.cost.evaluations},
                    {"operations", point.cost.operations},
                    {"seconds", point.seconds}};
  }
  json["status"] = point.failure.empty() ? "ok" : "failed";
  if (!point.failure.empty()) json["reason"] = point.failure;
  return json;
}

std::string as_json(const Options& options, const std::vector<StudyPoint>& points) {
  nlohmann::ordered_json json = {{"points", nlohmann::ordered_json::array()}};
  for (const StudyPoint& point : points) json["points"].push_back(point_json(options, point));
  return json.dump(2) + "\n";
}

/// A field between quotes, quotes within doubled (RFC 4180).
std::string quoted(const std::string& text) {
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + "\"";
}

std::string as_csv(const Options& options, const std::vector<StudyPoint>& points) {
  std::string text =
      "solver,filter,samples,levels,shape,s1,s2,tolerance,displacement_l2_max,"
      "displacement_l2_final,energy_norm_max,evaluations,operations,seconds,status\n";
  for (const StudyPoint& point : points) {
    text +=
        fmt::format("{},{},{},{},{},{},{},{},", point.solver, quoted(options.filter),
                    options.samples, options.levels, quoted(options.shape), options.damping[0],
                    options.damping[1], point.tolerance ? fmt::format("{}", *point.tolerance) : "");
    text += point.errors
                ? fmt::format("{},{},{},{},{},{},ok\n", point.errors->displacement_l2_max,
                              point.errors->displacement_l2_final, point.errors->energy_norm_max,
                              point.cost.evaluations, point.cost.operations, point.seconds)
                : ",,,,,,failed\n";
  }
  return text;
}

std::string as_text(const Options& options, const std::vector<StudyPoint>& points) {
  std::string text = fmt::format(
      "{}, {} samples, {} levels; {} released at rest from t = 0 to 1, damping {}, {}\n"
      "errors against the exact motion, relative to the initial state; of a closed form (no "
      "tolerance)\nthey are those of its model, which no tolerance makes smaller\n\n"
      "{:<24}  {:>9}  {:>9}  {:>9}  {:>9}  {:>11}  {:>10}  {:>9}\n",
      options.filter, options.samples, options.levels, options.shape, options.damping[0],
      options.damping[1], "solver", "tolerance", "L2 max", "L2 final", "energy", "evaluations",
      "operations", "seconds");
  for (const StudyPoint& point : points) {
    text += fmt::format("{:<24}  {:>9}  ", point.solver,
                        point.tolerance ? fmt::format("{:.3g}", *point.tolerance) : "-");
    if (!point.errors) {
      text += "failed: " + point.failure + "\n";
      continue;
    }
    text += fmt::format("{:>9.2e}  {:>9.2e}  {:>9.2e}  {:>11}  {:>10.3g}  {:>9.2e}\n",
                        point.errors->displacement_l2_max, point.errors->displacement_l2_final,
                        point.errors->energy_norm_max, point.cost.evaluations,
                        static_cast<double>(point.cost.operations), point.seconds);
  }
  return text;
}

void write(const std::filesystem::path& directory, const Options& options,
           const std::vector<StudyPoint>& points) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw std::system_error(error, "cannot make the folder " + directory.string());
  io::write_file(directory / "compare.json", as_json(options, points));
  io::write_file(directory / "compare.csv", as_csv(options, points));
}

void run(const Options& given) {
  const Options options = completed(given);
  const std::vector<StudyPoint> points = points_of(options);
  if (!options.directory.empty()) write(options.directory, options, points);
  const std::string text = options.format == "json"  ? as_json(options, points)
                           : options.format == "csv" ? as_csv(options, points)
                                                     : as_text(options, points);
  std::fputs(text.c_str(), stdout);
}

}  // namespace

void add_compare_command(CLI::App& app, ExitCode&) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "compare",
      "Errors and costs of the solvers of the equation of motion, against the exact one");
  command->add_option("--filter", options->filter, "A filter's name, or a JSON file with one's own")
      ->capture_default_str();
  command->add_option("--samples", options->samples, "Number of samples, a power of two")
      ->capture_default_str();
  command->add_option("--levels", options->levels, "Levels of decomposition; all if not given")
      ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--shape", options->shape,
                   "ellipse, star, dent, or the first contour of a drawing (.svg, .csv), fitted to "
                   "the unit circle, which is the rest shape")
      ->capture_default_str();
  command->add_option("--damping", options->damping, "s1,s2 of the damping C = s1 M + s2 K")
      ->delimiter(',')
      ->expected(2)
      ->default_str("0,0");
  command->add_option("--solvers", options->solvers, "Names, separated by commas; all if not given")
      ->delimiter(',');
  add_format_option(*command, options->format, {"text", "json", "csv"});
  command->add_option("-o,--output", options->directory,
                      "Also write compare.json and compare.csv into this folder");
  command->callback([options] { run(*options); });
}

}  // namespace wavecurve::tools
