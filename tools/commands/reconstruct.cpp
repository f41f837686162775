#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "wavecurve/curves/descriptor.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/animations/animated_svg.hpp"
#include "wavecurve/io/descriptor_json.hpp"
#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/io/load_filter.hpp"
#include "wavecurve/motion/animation.hpp"

#include "tools/commands/commands.hpp"
#include "tools/commands/input/drawing_input.hpp"

namespace wavecurve::tools {

namespace {

struct ReconstructOptions {
  std::string input, scale = "full", output;
};

std::string checked_ending(const std::string& output) {
  const std::string ending = std::filesystem::path(output).extension().string();
  if (ending != ".svg" && ending != ".csv") {
    throw std::invalid_argument(must_be("output", output, "a file ending in .svg or .csv"));
  }
  return ending;
}

/// A picture that stands still.
motion::Animation reconstructed(const Descriptor& descriptor, Eigen::Index scale) {
  const FilterBank<double> bank = io::load_filter_bank(descriptor.filter);
  motion::Animation still;
  still.view_box = descriptor.view_box;
  still.duration = 1;
  for (const LayerDescriptor& layer : descriptor.layers) {
    still.layers.push_back(
        {layer.id, {{0, reconstruct(layer, bank, descriptor.options, scale)}}, {{0, layer.paint}}});
  }
  return still;
}

/// Contours are numbered through all layers: two of them with the same number would be one.
std::string points_csv(const motion::Animation& still) {
  std::string text = "contour,x,y\n";
  int number = 0;
  for (const motion::AnimatedLayer& layer : still.layers) {
    for (const Contour& contour : layer.outline.front().contours) {
      for (const auto& point : contour.rowwise()) {
        text += fmt::format("{},{},{}\n", number, point[0], point[1]);
      }
      ++number;
    }
  }
  return text;
}

void run_reconstruct(const ReconstructOptions& options) {
  const std::string ending = checked_ending(options.output);
  const Descriptor descriptor = io::read_descriptor(options.input);
  const motion::Animation still =
      reconstructed(descriptor, parsed_scale(options.scale).value_or(descriptor.options.samples));
  io::OutputOptions output;
  output.accuracy = 1e-6;
  io::write_file(options.output,
                 ending == ".svg" ? io::animated_svg(still, output) : points_csv(still));
}

}  // namespace

void add_reconstruct_command(CLI::App& app, ExitCode&) {
  auto options = std::make_shared<ReconstructOptions>();
  CLI::App* command = app.add_subcommand(
      "reconstruct", "Draw a descriptor, in full or from its coarsest coefficients");
  command->add_option("DESCRIPTOR", options->input, "Descriptor written by describe (.json)")
      ->required();
  command
      ->add_option("--scale", options->scale,
                   "Number of coefficients to use per contour: a power of two, or full")
      ->capture_default_str();
  command
      ->add_option("-o,--output", options->output,
                   "A drawing (.svg), or contour,x,y of every sample (.csv)")
      ->required();
  command->callback([options] { run_reconstruct(*options); });
}

}  // namespace wavecurve::tools
