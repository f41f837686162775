#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/animations/animation_sheet.hpp"
#include "wavecurve/io/animations/end_paths.hpp"
#include "wavecurve/io/animations/write_animation.hpp"
#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/io/load_filter.hpp"
#include "wavecurve/motion/chain.hpp"
#include "wavecurve/motion/ease.hpp"
#include "wavecurve/motion/morph/avoid_crossings.hpp"
#include "wavecurve/motion/morph/make_morph.hpp"
#include "wavecurve/motion/there_and_back.hpp"

#include "tools/commands/commands.hpp"
#include "tools/commands/input/animation_output.hpp"
#include "tools/commands/input/drawing_input.hpp"
#include "tools/commands/input/motion_options.hpp"
#include "tools/commands/input/number_option.hpp"
#include "tools/commands/output/crossings_table.hpp"
#include "tools/commands/progress.hpp"

namespace wavecurve::tools {

namespace {

constexpr int most_drawings = 1000;

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
  std::vector<std::string> drawings;
  std::string filter = "bspline4.4", scale = "full";
  std::vector<std::string> map, starts, anchors;
  std::vector<double> durations{2};
  AnimationOutput output;
  motion::MorphOptions morph;
  MotionOptions motion;
  motion::Ease ease = motion::Ease::linear;
  Crossings crossings = Crossings::ignored;
  std::optional<motion::Detail> detail;
  bool loop = false, paths = false, rotation = false;
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

/// A layer and a number behind its last colon; none for another text.
std::optional<std::pair<std::string, std::size_t>> numbered(const std::string& text) {
  const auto colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0) return std::nullopt;
  const auto number = parsed_whole_number(text.substr(colon + 1));
  if (!number || *number < 0) return std::nullopt;
  return std::pair(text.substr(0, colon), static_cast<std::size_t>(*number));
}

/// a=b for layers, or a:0=b:1 for their contours.
void add_to_map(motion::MorphOptions& morph, const std::string& text) {
  const auto [from, to] =
      parsed_pair(text, "--map", "two layers, a=b, or contours of them, a:0=b:1");
  const auto source = numbered(from), destination = numbered(to);
  if (source && destination) {
    return morph.contours.push_back(
        {source->first, source->second, destination->first, destination->second});
  }
  morph.map.emplace_back(from, to);
}

motion::Anchor parsed_anchor(const std::string& text) {
  const char* form = "a layer and vertices of its two shapes, layer:0=2";
  const auto [from, to] = parsed_pair(text, "--anchor", form);
  const auto source = numbered(from);
  const auto destination = parsed_whole_number(to);
  if (!source || !destination || *destination < 0) {
    throw std::invalid_argument(must_be("--anchor", text, form));
  }
  return {source->first, source->second, static_cast<std::size_t>(*destination)};
}

motion::MorphOptions morph_options(const MorphOptions& options) {
  motion::MorphOptions morph = options.morph;
  morph.bank = io::load_filter_bank(options.filter);
  morph.scale = parsed_scale(options.scale);
  for (const std::string& text : options.map) add_to_map(morph, text);
  for (const std::string& text : options.anchors) morph.anchors.push_back(parsed_anchor(text));
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

/// Only a linear morph of two drawings in even time can be rescaled by the viewer of a page.
bool is_rescalable(const MorphOptions& options) {
  return !options.motion.is_physical() && options.ease == motion::Ease::linear &&
         !options.output.is_sheet() && options.drawings.size() == 2;
}

bool is_chain(const MorphOptions& options) { return options.drawings.size() > 2; }

/// From drawing to drawing, and from the last to the first where a chain is played endlessly.
std::size_t number_of_legs(const MorphOptions& options) {
  return options.drawings.size() - (is_chain(options) && options.loop ? 0 : 1);
}

/// The time of each leg, in seconds; with --fps of whole frames.
std::vector<double> leg_durations(const MorphOptions& options) {
  const std::size_t legs = number_of_legs(options);
  std::vector<double> durations = options.durations;
  if (durations.size() == 1) durations.resize(legs, durations.front());
  if (durations.size() != legs) {
    throw std::invalid_argument(
        must_be("the number of durations", durations.size(),
                legs == 1 ? "1" : fmt::format("1 or {}, the number of morphs", legs)));
  }
  if (!options.output.rate()) return durations;
  for (double& duration : durations) {
    duration = options.output.steps(duration) / *options.output.rate();
  }
  return durations;
}

int number_of_frames(const MorphOptions& options, const std::vector<double>& durations) {
  if (!options.output.rate())
    return options.output.frames().value_or(options.output.is_sheet() ? 12 : 60);
  return 1 + options.output.steps(std::accumulate(durations.begin(), durations.end(), 0.0));
}

motion::Animation moving(const MorphOptions& options, int frames, const motion::Morph& morph) {
  const motion::Animation in_even_time =
      options.motion.is_physical()
          ? motion::physical_animation(morph, options.motion.physical(frames))
          : motion::animate(morph);
  return motion::eased(in_even_time, options.ease, frames);
}

io::OutputOptions output_options(const MorphOptions& options, const ViewBox& box, int frames,
                                 Progress& progress) {
  io::OutputOptions output = options.output.options(box);
  output.frames = frames;
  output.loop = options.loop;
  output.progress = [&](int done, int all) {
    progress.show(static_cast<std::size_t>(done), static_cast<std::size_t>(all));
  };
  return output;
}

void write_still_or_moving(const MorphOptions& options, const motion::Animation& animation,
                           const io::OutputOptions& output) {
  const std::string& path = options.output.path();
  if (options.paths) return io::write_file(path, io::end_paths(animation, output));
  if (options.output.is_sheet())
    return io::write_file(path, io::animation_sheet(animation, output));
  io::write_animation(path, animation, output);
}

void write_morph(const MorphOptions& options, int frames, const motion::Morph& morph) {
  Progress progress("frames");
  io::OutputOptions output = output_options(options, morph.view_box, frames, progress);
  if (is_rescalable(options) && !options.paths) {
    return io::write_animation(options.output.path(), morph, output);
  }
  const motion::Animation animation = moving(options, frames, morph);
  if (!options.loop) return write_still_or_moving(options, animation, output);
  output.frames = 2 * frames - 1;  // at the same rate
  io::write_animation(options.output.path(), motion::there_and_back(animation), output);
}

/// The legs one after the other, each with its share of the frames.
void write_chain(const MorphOptions& options, const motion::MorphOptions& how,
                 const std::vector<double>& durations, int frames) {
  std::vector<Drawing> drawings;
  for (const std::string& path : options.drawings) {
    drawings.push_back(drawing_of(path, options.points));
    drawings.back() = motion::fitted(drawings.back(), drawings.front().view_box);
  }
  const double whole = std::accumulate(durations.begin(), durations.end(), 0.0);
  std::vector<motion::Animation> legs;
  for (std::size_t i = 0; i < durations.size(); ++i) {
    motion::MorphOptions leg = how;
    leg.duration = durations[i];
    const double steps = std::round((frames - 1) * durations[i] / whole);
    legs.push_back(
        moving(options, std::max(2, 1 + static_cast<int>(steps)),
               motion::make_morph(drawings[i], drawings[(i + 1) % drawings.size()], leg)));
  }
  const motion::Animation animation = motion::chain(legs);
  Progress progress("frames");
  write_still_or_moving(options, animation,
                        output_options(options, animation.view_box, frames, progress));
}

/// What is about two drawings, not more.
void check_pair_options(const MorphOptions& options) {
  const std::pair<const char*, bool> used[] = {
      {"--map", !options.map.empty()},
      {"--start", !options.starts.empty()},
      {"--anchor", !options.anchors.empty()},
      {"--crossings", options.crossings != Crossings::ignored},
      {"--paths", options.paths}};
  for (const auto& [name, is_used] : used) {
    if (!is_used) continue;
    throw std::invalid_argument(
        fmt::format("{} takes two drawings, not {}", name, options.drawings.size()));
  }
}

void check(const MorphOptions& options) {
  options.output.check();
  if (is_chain(options)) check_pair_options(options);
  if (options.paths && options.output.ending() != ".json") {
    throw std::invalid_argument(must_be("the file of --paths", options.output.path(), "a .json"));
  }
  if (options.paths && (options.motion.is_physical() || options.ease != motion::Ease::linear)) {
    throw std::invalid_argument("--paths writes both ends alone, whatever the motion in between");
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
  const std::vector<double> durations = leg_durations(options);
  const int frames = number_of_frames(options, durations);
  motion::MorphOptions how = morph_options(options);
  if (is_chain(options)) return write_chain(options, how, durations, frames);
  how.duration = durations.front();
  const Drawing source = drawing_of(options.drawings[0], options.points),
                destination = drawing_of(options.drawings[1], options.points);
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
  command
      ->add_option("DRAWINGS", options->drawings,
                   "Two drawings or more, .svg or .csv, each of which becomes the next")
      ->required()
      ->expected(2, most_drawings);
  options->output.add_to(command, "60 by default, 12 on a sheet");
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
  CLI::Option* duration =
      command->add_option("--duration", options->durations,
                          "Seconds of each morph; of several drawings also as a list, 1,2,...");
  duration->delimiter(',')->allow_extra_args(false)->check(duration_check())->default_str("2");
  CLI::Option* loop = command->add_flag(
      "--loop", options->loop,
      "Play endlessly: forward and backward, or from the last of several drawings "
      "to the first");
  command
      ->add_option(
          "--map", options->map,
          "Match layer a of the source with layer b of the destination: a=b; or contours of "
          "them, counted from 0: a:0=b:1")
      ->allow_extra_args(false);
  command
      ->add_option("--start", options->starts,
                   "First point of the destination's contours in a layer: layer=17")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--anchor", options->anchors,
          "Vertex 0 of a layer of the source becomes vertex 2 of its partner: layer:0=2; without "
          "any, corners that both share stay")
      ->allow_extra_args(false);
  add_point_options(command, options->points);
  command->add_flag("--rotation", options->rotation, "Remove a rotation before points are matched");
  add_choice(command, "--crossings", options->crossings, crossings_modes,
             "report them by frame and layer, or avoid them by scales chosen from --scale on");
  options->output.sheet()->excludes(loop, duration);
  command
      ->add_flag("--paths", options->paths,
                 "Write the paths of both ends (.json), with equal commands, for CSS or your own "
                 "tweening")
      ->excludes(loop, duration, options->output.sheet(), "--frames", "--fps", "--size",
                 "--background");
  command->callback([options, &exit_code] { run_morph(*options, exit_code); });
}

}  // namespace wavecurve::tools
