#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/animations/animation_sheet.hpp"
#include "wavecurve/io/animations/write_animation.hpp"
#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/io/load_filter.hpp"
#include "wavecurve/motion/ease.hpp"
#include "wavecurve/motion/morph/avoid_crossings.hpp"
#include "wavecurve/motion/morph/make_morph.hpp"
#include "wavecurve/motion/there_and_back.hpp"

#include "tools/commands/commands.hpp"
#include "tools/commands/input/drawing_input.hpp"
#include "tools/commands/input/motion_options.hpp"
#include "tools/commands/input/number_option.hpp"
#include "tools/commands/output/crossings_table.hpp"
#include "tools/commands/progress.hpp"

namespace wavecurve::tools {

namespace {

enum class Crossings { ignored, report, avoid };

const std::map<std::string, motion::Detail> details{{"drop", motion::Detail::drop},
                                                    {"blend", motion::Detail::blend},
                                                    {"stage", motion::Detail::stage}};
const std::map<std::string, motion::Ease> eases{{"linear", motion::Ease::linear},
                                                {"in", motion::Ease::in},
                                                {"out", motion::Ease::out},
                                                {"in-out", motion::Ease::in_out}};
const std::map<std::string, Crossings> crossings_modes{{"report", Crossings::report},
                                                       {"avoid", Crossings::avoid}};

struct MorphOptions {
  std::string source, destination, output, filter = "bspline4.4", scale = "full";
  std::vector<std::string> map, starts;
  motion::MorphOptions morph;
  MotionOptions motion;
  motion::Ease ease = motion::Ease::linear;
  Crossings crossings = Crossings::ignored;
  std::optional<motion::Detail> detail;
  std::optional<int> frames;
  double tolerance = 0;
  bool loop = false, sheet = false, rotation = false;
  io::PointOptions points;
};

/// The two sides of the last =, since an id may hold one too.
std::pair<std::string, std::string> parsed_pair(const std::string& text, const char* option,
                                                const char* form) {
  const auto equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    throw std::invalid_argument(must_be(option, text, form));
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

motion::MorphOptions morph_options(const MorphOptions& options) {
  motion::MorphOptions morph = options.morph;
  morph.bank = io::load_filter_bank(options.filter);
  morph.scale = parsed_scale(options.scale);
  for (const std::string& text : options.map) {
    morph.map.push_back(parsed_pair(text, "--map", "two layers, a=b"));
  }
  for (const std::string& text : options.starts) {
    const auto [layer, start] = parsed_pair(text, "--start", "a layer and a point, layer=17");
    const auto number = parsed_whole_number(start);
    if (!number) {
      throw std::invalid_argument(must_be("--start", start, "the number of a point"));
    }
    morph.starts.emplace_back(layer, *number);
  }
  if (options.rotation) morph.rotation = Rotation::taken_out;
  // With all details blended there would be no scale to choose.
  const bool avoid = options.crossings == Crossings::avoid;
  morph.detail = options.detail.value_or(avoid ? motion::Detail::stage : motion::Detail::blend);
  return morph;
}

/// The normalised times of the frames but the first and the last.
std::vector<double> inner_times(int frames, motion::Ease ease) {
  std::vector<double> taus;
  for (int i = 1; i + 1 < frames; ++i) {
    taus.push_back(motion::eased(ease, static_cast<double>(i) / (frames - 1)));
  }
  return taus;
}

motion::ChosenMorph without_crossings(const Drawing& source, const Drawing& destination,
                                      motion::MorphOptions options,
                                      const std::vector<double>& taus) {
  std::vector<motion::Morph> alternatives{motion::make_morph(source, destination, options)};
  if (options.rotation == Rotation::kept) {
    options.rotation = Rotation::taken_out;
    alternatives.push_back(motion::make_morph(source, destination, options));
  }
  Progress progress("crossings");
  return motion::avoid_crossings(
      alternatives, taus, [&](std::size_t done, std::size_t all) { progress.show(done, all); });
}

/// Only a linear morph in even time can be rescaled by the viewer of a page.
bool is_rescalable(const MorphOptions& options) {
  return !options.motion.is_physical() && options.ease == motion::Ease::linear && !options.sheet;
}

void write_morph(const MorphOptions& options, int frames, const motion::Morph& morph) {
  Progress progress("frames");
  io::OutputOptions output;
  output.frames = frames;
  output.tolerance = options.tolerance;
  output.loop = options.loop;
  output.progress = [&](int done, int all) {
    progress.show(static_cast<std::size_t>(done), static_cast<std::size_t>(all));
  };
  const bool is_physical = options.motion.is_physical();
  if (is_rescalable(options)) {
    return io::write_animation(options.output, morph, output);
  }
  const motion::Animation in_even_time =
      is_physical ? motion::physical_animation(morph, options.motion.physical(frames))
                  : motion::animate(morph);
  const motion::Animation animation = motion::eased(in_even_time, options.ease, frames);
  if (options.sheet) {
    return io::write_file(options.output, io::animation_sheet(animation, output));
  }
  if (!options.loop) return io::write_animation(options.output, animation, output);
  output.frames = 2 * frames - 1;  // at the same rate
  io::write_animation(options.output, motion::there_and_back(animation), output);
}

void check(const MorphOptions& options) {
  check_sheet(options.sheet, options.output);
  check_tolerance(options.tolerance, options.output);
  if (options.tolerance > 0 && options.output.ends_with(".html") && is_rescalable(options)) {
    throw std::invalid_argument(
        "--tolerance is not for the page of a linear morph, which holds control points");
  }
  options.motion.check();
  if (options.motion.is_physical() && options.crossings != Crossings::ignored) {
    throw std::invalid_argument("--crossings takes --motion linear, not physical");
  }
}

bool has_crossings(const motion::ChosenMorph& chosen) {
  return std::any_of(chosen.choices.begin(), chosen.choices.end(),
                     [](const motion::ScaleChoice& choice) { return choice.crossings > 0; });
}

void run_morph(const MorphOptions& options, ExitCode& exit_code) {
  check(options);
  const int frames = options.frames.value_or(options.sheet ? 12 : 60);
  const motion::MorphOptions how = morph_options(options);
  const Drawing source = drawing_of(options.source, options.points),
                destination = drawing_of(options.destination, options.points);
  const std::vector<double> taus = inner_times(frames, options.ease);
  motion::Morph morph;
  std::string text;
  if (options.crossings == Crossings::avoid) {
    motion::ChosenMorph chosen = without_crossings(source, destination, how, taus);
    text = choices_table(chosen);
    if (has_crossings(chosen)) exit_code = differs;
    morph = std::move(chosen.morph);
  } else {
    morph = motion::make_morph(source, destination, how);
    if (options.crossings == Crossings::report) text = crossings_table(morph, taus);
  }
  write_morph(options, frames, morph);
  fmt::print("{}", text);
}

/// An option whose values have names; Target is Value, or std::optional of it.
template <class Target, class Value>
void add_choice(CLI::App* command, const std::string& name, Target& target,
                const std::map<std::string, Value>& choices, const std::string& text) {
  std::vector<std::string> names;
  for (const auto& [choice, value] : choices) names.push_back(choice);
  command
      ->add_option_function<std::string>(
          name, [&](const std::string& choice) { target = choices.at(choice); }, text)
      ->check(CLI::IsMember(names).description(""));
}

}  // namespace

void add_morph_command(CLI::App& app, ExitCode& exit_code) {
  auto options = std::make_shared<MorphOptions>();
  CLI::App* command = app.add_subcommand(
      "morph",
      "Morph one drawing into another, layer by layer, as an animation or a sheet of frames");
  command->add_option("SOURCE", options->source, "The first drawing, .svg or .csv")->required();
  command->add_option("DESTINATION", options->destination, "The second drawing")->required();
  command
      ->add_option(
          "-o,--output", options->output,
          "Output; its extension selects the format: .svg .json (Lottie) .html .gif .mp4 .webm "
          ".png (folder)")
      ->required();
  command->add_option("--frames", options->frames, "Number of frames; 60 by default, 12 on a sheet")
      ->check(frames_check());
  command->add_option("--filter", options->filter, "Filter name, or path to a JSON filter file")
      ->capture_default_str();
  command->add_option("--samples", options->morph.samples, "Points per contour, a power of two")
      ->check(samples_check())
      ->capture_default_str();
  command
      ->add_option("--scale", options->scale,
                   "Control points that are interpolated: a power of two, at least 4, or full")
      ->capture_default_str();
  add_choice(command, "--detail", options->detail, details,
             "What happens to finer detail: drop, blend or stage; by default blend, or stage with "
             "--crossings avoid");
  add_choice(command, "--ease", options->ease, eases, "Easing: linear (default), in, out, in-out");
  options->motion.add_to(command);
  CLI::Option* duration = command->add_option("--duration", options->morph.duration, "Seconds");
  duration->check(duration_check())->capture_default_str();
  CLI::Option* loop =
      command->add_flag("--loop", options->loop, "Play forward and backward, endlessly");
  command
      ->add_option("--map", options->map,
                   "Match layer a of the source with layer b of the destination: a=b")
      ->allow_extra_args(false);
  command
      ->add_option("--start", options->starts,
                   "First point of the destination's contours in a layer: layer=17")
      ->allow_extra_args(false);
  add_point_options(command, options->points);
  command->add_flag("--rotation", options->rotation, "Remove a rotation before points are matched");
  add_choice(command, "--crossings", options->crossings, crossings_modes,
             "report them by frame and layer, or avoid them by scales chosen from --scale on");
  command->add_flag("--sheet", options->sheet, "Write the frames as one picture")
      ->excludes(loop, duration);
  command
      ->add_option(
          "--tolerance", options->tolerance,
          "Maximum distance of the fitted cubics from the contour, in drawing units; 0 writes "
          "polygons")
      ->check(tolerance_check())
      ->capture_default_str();
  command->callback([options, &exit_code] { run_morph(*options, exit_code); });
}

}  // namespace wavecurve::tools
