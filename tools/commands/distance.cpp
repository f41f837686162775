#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/curves/shape_distance.hpp"
#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/io/load_filter.hpp"
#include "wavecurve/transform/bands.hpp"

#include "tools/commands/commands.hpp"
#include "tools/commands/input/drawing_input.hpp"
#include "tools/commands/input/number_option.hpp"
#include "tools/commands/terminal.hpp"

namespace wavecurve::tools {

namespace {

struct DistanceOptions {
  std::string first, second, filter = "coif2";
  long samples = 256;
  int levels = -1;  ///< -1: down to 8 coefficients
  io::PointOptions points;
};

/// What is compared of a drawing.
struct Outline {
  Contour points;
  bool closed = false;
};

/// The contour of the largest area; where none has one, as of open lines, the first.
Outline outline_of(const std::string& path, const DistanceOptions& options) {
  const Drawing drawing = drawing_of(path, options.points);
  Outline largest;
  std::size_t count = 0;
  double area = -1;
  for (const Layer& layer : drawing.layers) {
    const auto contours = sample_layer(layer, options.samples);
    for (std::size_t i = 0; i < contours.size(); ++i, ++count) {
      if (std::abs(signed_area(contours[i])) <= area) continue;
      area = std::abs(signed_area(contours[i]));
      largest = {contours[i], layer.subpaths[i].closed || layer.paint.fill.has_value()};
    }
  }
  if (count > 1)
    print_message(fmt::format("{}: of {} contours the largest is compared", path, count));
  return largest;
}

void print_distance(const DistanceOptions& options) {
  const FilterBank<double> bank = io::load_filter_bank(options.filter);
  check_samples(options.samples);
  constexpr int coarsest = 3;  // log2 of 8 coefficients
  const int levels =
      options.levels < 0 ? std::max(0, all_levels(options.samples) - coarsest) : options.levels;
  const Outline first = outline_of(options.first, options),
                second = outline_of(options.second, options);
  if (first.closed != second.closed) {
    throw std::invalid_argument(fmt::format("{} is {}, {} is {}; both must be one or the other",
                                            options.first, first.closed ? "closed" : "open",
                                            options.second, second.closed ? "closed" : "open"));
  }
  const ShapeDistance distance =
      shape_distance(first.points, second.points, bank, levels, first.closed);
  fmt::print("filter {}, {} samples, size 1 (root mean square distance from the middle)\n\n",
             options.filter, options.samples);
  fmt::print("scale     distance\n");
  for (int i = 0; i <= levels; ++i) {
    fmt::print("{:<8}  {:.6f}\n", options.samples >> (levels - i), distance.by_scale[i]);
  }
  fmt::print("whole     {:.6f}\n", distance.total);
  if (!first.closed) return;
  constexpr Eigen::Index most_harmonics = 20;
  const auto harmonics = static_cast<int>(std::min(most_harmonics, (options.samples - 1) / 2));
  fmt::print("\nelliptic Fourier descriptors, {} harmonics: {:.6f}\n", harmonics,
             elliptic_fourier_distance(first.points, second.points, harmonics));
}

}  // namespace

void add_distance_command(CLI::App& app, ExitCode&) {
  auto options = std::make_shared<DistanceOptions>();
  CLI::App* command = app.add_subcommand(
      "distance",
      "Print how far two outlines are from each other as shapes, by scale; start, direction, "
      "rotation, size and place do not count");
  command->add_option("A", options->first, "A drawing (.svg) or points (.csv)")->required();
  command->add_option("B", options->second, "Another one")->required();
  command
      ->add_option("--filter", options->filter,
                   "Orthonormal filter name, or path to a JSON filter file")
      ->capture_default_str();
  command
      ->add_option("--levels", options->levels,
                   "Levels of decomposition; by default down to 8 coefficients")
      ->check(levels_check());
  command->add_option("--samples", options->samples, "Samples per outline, a power of two")
      ->check(samples_check())
      ->capture_default_str();
  add_point_options(command, options->points);
  command->callback([options] { print_distance(*options); });
}

}  // namespace wavecurve::tools
