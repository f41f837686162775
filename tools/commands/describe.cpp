#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "wavecurve/curves/descriptor.hpp"
#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/io/descriptor_json.hpp"
#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/io/load_filter.hpp"
#include "wavecurve/transform/bands.hpp"

#include "tools/commands/commands.hpp"
#include "tools/commands/input/drawing_input.hpp"
#include "tools/commands/input/number_option.hpp"

namespace wavecurve::tools {

namespace {

struct DescribeOptions {
  /// Smooth at every scale, and symmetric, so that the two ways of an open stroke coincide.
  std::string filter = "bspline4.4";
  std::string input, output;
  long samples = 256;
  int levels = -1;  ///< -1: down to 16 coefficients
  bool interpolate = false, keep_corners = false, normalize = false;
  io::PointOptions points;
};

int default_levels(Eigen::Index samples) {
  constexpr int coarsest = 4;  // log2 of 16, the publication's coarsest scale of 1024 samples
  return std::max(0, all_levels(samples) - coarsest);
}

Descriptor described(const DescribeOptions& options) {
  const FilterBank<double> bank = io::load_filter_bank(options.filter);
  check_samples(options.samples);
  DescriptorOptions how;
  how.samples = options.samples;
  how.levels = options.levels < 0 ? default_levels(options.samples) : options.levels;
  how.mode = options.interpolate ? SampleMode::interpolate : SampleMode::samples;
  how.corners = options.keep_corners ? Corners::kept : Corners::ignored;
  how.normalized = options.normalize;
  multiscale_bands(how.samples, how.levels);
  Descriptor descriptor = describe(drawing_of(options.input, options.points), bank, how);
  // A file's taps are found again by its path.
  if (options.filter.ends_with(".json")) descriptor.filter = options.filter;
  return descriptor;
}

void print_row(const std::string& layer, std::size_t contour, const ContourDescriptor& descriptor,
               int levels, int width) {
  fmt::print("{:<{}}  {:>7}  {:<6}  {:>10.6g}", layer, width, contour,
             descriptor.closed ? "closed" : "open", descriptor.length);
  for (double share : energy_shares(descriptor.coefficients, levels)) {
    fmt::print("  {:>8.3g}", 100 * share);
  }
  fmt::print("\n");
}

void print_table(const Descriptor& descriptor) {
  const DescriptorOptions& how = descriptor.options;
  fmt::print("filter {}, {} samples a contour, {} levels\n", printable(descriptor.filter),
             how.samples, how.levels);
  fmt::print(
      "share of the energy about the mean, in %: of the coarsest scale, then of the details "
      "that lead to each finer one\n\n");
  std::size_t width = 5;
  for (const LayerDescriptor& layer : descriptor.layers) {
    width = std::max(width, printable(layer.id).size());
  }
  fmt::print("{:<{}}  {:>7}  {:<6}  {:>10}", "layer", width, "contour", "", "length");
  for (int level = how.levels; level >= 0; --level) fmt::print("  {:>8}", how.samples >> level);
  fmt::print("\n");
  for (const LayerDescriptor& layer : descriptor.layers) {
    for (std::size_t i = 0; i < layer.contours.size(); ++i) {
      print_row(printable(layer.id), i, layer.contours[i], how.levels, static_cast<int>(width));
    }
  }
}

void run_describe(const DescribeOptions& options) {
  const Descriptor descriptor = described(options);
  if (options.output.empty()) return print_table(descriptor);
  io::write_file(options.output, io::descriptor_json(descriptor));
}

}  // namespace

void add_describe_command(CLI::App& app, ExitCode&) {
  auto options = std::make_shared<DescribeOptions>();
  CLI::App* command = app.add_subcommand(
      "describe",
      "Print the wavelet descriptor of a drawing: lengths and energies, or all of it as JSON");
  command->add_option("IN", options->input, "A drawing (.svg) or points (.csv)")->required();
  command->add_option("--filter", options->filter, "Filter name, or path to a JSON filter file")
      ->capture_default_str();
  command
      ->add_option("--levels", options->levels,
                   "Levels of decomposition; by default down to 16 coefficients")
      ->check(levels_check());
  command->add_option("--samples", options->samples, "Samples per contour, a power of two")
      ->check(samples_check())
      ->capture_default_str();
  command->add_flag("--interpolate", options->interpolate,
                    "The curve passes through the samples; without, they are its finest "
                    "coefficients, as in the publication");
  CLI::Option* corners =
      command->add_flag("--keep-corners", options->keep_corners, "Place a sample on every corner");
  command
      ->add_flag("--normalize", options->normalize,
                 "Remove start, direction, rotation, size and place, contour by contour")
      ->excludes(corners);
  add_point_options(command, options->points);
  command->add_option("-o,--output", options->output, "File for the descriptor (JSON)");
  command->callback([options] { run_describe(*options); });
}

}  // namespace wavecurve::tools
