#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "wavecurve/io/animations/animation_sheet.hpp"
#include "wavecurve/io/animations/write_animation.hpp"
#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/io/load_filter.hpp"
#include "wavecurve/io/tracks/gait_parameters_json.hpp"
#include "wavecurve/io/tracks/read_limb_tracks.hpp"
#include "wavecurve/motion/gait/model/fit_gait.hpp"
#include "wavecurve/motion/gait/walk/gait_animation.hpp"

#include "tools/commands/commands.hpp"
#include "tools/commands/input/animation_output.hpp"
#include "tools/commands/input/drawing_input.hpp"
#include "tools/commands/input/number_option.hpp"
#include "tools/commands/output/gait_table.hpp"
#include "tools/commands/progress.hpp"
#include "tools/commands/terminal.hpp"

namespace wavecurve::tools {

namespace {

// fit

struct FitOptions {
  std::vector<std::string> tracks;
  std::string output, filter = "bspline4.4";
  std::vector<std::string> models;
  io::TrackOptions reading;
  std::string scale = "64";
  std::vector<double> key_frames;
};

void fit(const FitOptions& options) {
  gait::GaitFitOptions how{io::load_filter_bank(options.filter), options.filter};
  how.scale = parsed_scale(options.scale);
  if (!options.models.empty()) how.models.clear();
  for (const std::string& name : options.models) how.models.push_back(gait::find_gait_model(name));
  if (!options.key_frames.empty()) how.key_frames = {options.key_frames[0], options.key_frames[1]};
  std::vector<std::string> warnings;
  const gait::LimbTracks tracks = io::read_limb_tracks(
      {options.tracks.begin(), options.tracks.end()}, options.reading, &warnings);
  for (const std::string& warning : warnings) {
    print_message(options.tracks.front() + ": " + warning);
  }
  const gait::GaitFit fitted = gait::fit_gait(tracks, how);
  io::write_file(options.output, io::gait_parameters_json(fitted.parameters));
  if (fitted.cycle.is_loop) fmt::print("the record ends where it begins: one cycle\n");
  fmt::print("{}", gait_summary(fitted.parameters));
}

void add_fit(CLI::App* gait) {
  auto options = std::make_shared<FitOptions>();
  CLI::App* command = gait->add_subcommand("fit", "Fit motion parameters to traced contours");
  command
      ->add_option(
          "TRACKS", options->tracks,
          "A table of contours or joints (.csv, .csv.gz; also DeepLabCut's and SLEAP's), SVG frames, or a folder of them")
      ->required();
  command->add_option("-o,--output", options->output, "The parameters, .json")->required();
  command->add_option("--filter", options->filter, "Filter name, or path to a JSON filter file")
      ->capture_default_str();
  command
      ->add_option("--scale", options->scale,
                   "Control points per outline: a power of two, at least 4, or full")
      ->capture_default_str();
  command
      ->add_option("--samples", options->reading.samples,
                   "Points per outline, a power of two; as in the file by default")
      ->check(samples_check());
  command
      ->add_option("--thickness", options->reading.thickness,
                   "Thickness of limbs that are given by joints, as a fraction of their length")
      ->check(number_above(0, 10, "times the length of the limb"))
      ->capture_default_str();
  command
      ->add_option("--likelihood", options->reading.least_likelihood,
                   "Points less likely are interpolated, in tables that tell it")
      ->check(number_from(0, 1))
      ->capture_default_str();
  command
      ->add_option(
          "--key-frames", options->key_frames,
          "Times t1,t2 of the publication's key frames; LF's first lift-off, and a quarter "
          "of the period later")
      ->delimiter(',')
      ->expected(2)
      ->check(number_from(-1e12, 1e12, "units of the record's times"));
  command
      ->add_option("--model", options->models,
                   "Models, a,b,...: the one of the least cross-validated error is taken; of all")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->callback([options] { fit(*options); });
}

// synthesize

struct SynthesisOptions {
  std::string parameters, drawing, gait;
  AnimationOutput output;
  gait::GaitAnimationOptions animation;
  std::optional<double> period;
  bool smooth = false;
};

/// Seconds of a cycle: the record's, if that can be seconds and not numbers of frames.
double cycle_duration(const SynthesisOptions& options, const gait::GaitParameters& parameters) {
  if (options.period) return *options.period;
  return parameters.period >= 0.1 && parameters.period <= 4 ? parameters.period : 1;
}

/// Without the last frame, which is the first: what a film of frames shows.
motion::Animation open_loop(motion::Animation animation, int frames) {
  for (motion::AnimatedLayer& layer : animation.layers) layer.outline.pop_back();
  animation.duration *= static_cast<double>(frames - 1) / frames;
  return animation;
}

void write_walk(const SynthesisOptions& options, const gait::GaitAnimation& walk, int frames) {
  Progress progress("frames");
  io::OutputOptions output = options.output.options(walk.animation.view_box);
  output.loop = true;
  output.progress = [&](int done, int all) {
    progress.show(static_cast<std::size_t>(done), static_cast<std::size_t>(all));
  };
  const std::string& path = options.output.path();
  if (options.output.is_sheet()) {
    output.frames = frames;
    return io::write_file(path, io::animation_sheet(open_loop(walk.animation, frames), output));
  }
  const bool is_film = !io::holds_curves(path);
  output.frames = is_film ? frames : frames + 1;
  io::write_animation(path, is_film ? open_loop(walk.animation, frames) : walk.animation, output);
}

void synthesize(const SynthesisOptions& options) {
  options.output.check();
  gait::GaitAnimationOptions how = options.animation;
  if (!options.gait.empty()) how.gait = gait::find_canine_gait(options.gait);
  const gait::GaitParameters parameters = io::read_gait_parameters(options.parameters);
  how.bank = io::load_filter_bank(parameters.filter);
  how.cycle_duration = cycle_duration(options, parameters);
  how.frames = options.output.frames().value_or(how.frames);
  if (const auto rate = options.output.rate()) {
    how.frames = std::max(2, options.output.steps(how.cycles * how.cycle_duration));
    how.cycle_duration = how.frames / *rate / how.cycles;
  }
  if (options.smooth) how.continuity = gait::Continuity::velocity;
  const gait::GaitAnimation walk = gait::animate_gait(parameters, drawing_of(options.drawing), how);
  write_walk(options, walk, how.frames);
  fmt::print(
      "stride {:.4g} units of the drawing, {:.4g} seconds a cycle\n"
      "standing feet slide by at most {:.2f} % of the stride, and are off the ground by {:.2f} %\n"
      "(before they were held to the ground they slid by {:.2f} %)\n",
      walk.stride, how.cycle_duration, 100 * walk.slide, 100 * walk.lift, 100 * walk.slide_before);
}

/// "walk, trot, pace, gallop".
std::string known_gaits() {
  std::vector<std::string> names;
  for (const gait::CanineGait& gait : gait::canine_gaits()) names.push_back(gait.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

void add_synthesize(CLI::App* gait) {
  auto options = std::make_shared<SynthesisOptions>();
  CLI::App* command =
      gait->add_subcommand("synthesize", "Animate a drawing that walks by fitted parameters");
  command->add_option("PARAMS", options->parameters, "Parameters written by gait fit (.json)")
      ->required();
  command
      ->add_option("DRAWING", options->drawing,
                   "An .svg with the layers LF, RF, LH, RH, and others")
      ->required();
  options->output.add_to(command, "60 over all cycles by default");
  CLI::Option* gait_name =
      command->add_option("--gait", options->gait, known_gaits() + "; by default as recorded");
  command->add_option("--cycles", options->animation.cycles, "Cycles")
      ->check(whole_number_from(1, 1000))
      ->capture_default_str();
  command
      ->add_option("--scale", options->animation.scale,
                   "Control points a contour, a power of two from 4 on; all points")
      ->check(samples_check());
  command->add_option("--samples", options->animation.samples, "Points per contour, a power of two")
      ->check(samples_check())
      ->capture_default_str();
  command
      ->add_option(
          "--period", options->period,
          "Seconds per cycle; by default the record's, or 1 if its times are frame numbers")
      ->check(duration_check());
  command->add_flag("--smooth", options->smooth,
                    "Make velocities continuous at key frames, not only positions");
  command
      ->add_flag("--subcycles", options->animation.subcycles,
                 "The publication's cycle: A to D from two key frames and gammas")
      ->excludes(gait_name);
  command->callback([options] { synthesize(*options); });
}

// show

void add_show(CLI::App* gait) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = gait->add_subcommand("show", "Print fitted parameters as tables");
  command->add_option("PARAMS", *path, "Parameters written by gait fit (.json)")->required();
  command->callback([path] { fmt::print("{}", gait_table(io::read_gait_parameters(*path))); });
}

}  // namespace

void add_gait_command(CLI::App& app, ExitCode&) {
  CLI::App* gait =
      app.add_subcommand("gait", "Fit the motion of a gait, and animate drawings that walk by it");
  gait->require_subcommand(1);
  add_fit(gait);
  add_synthesize(gait);
  add_show(gait);
}

}  // namespace wavecurve::tools
