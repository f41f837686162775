#include "tools/commands/input/animation_output.hpp"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/animations/write_animation.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_colour.hpp"

#include "tools/commands/input/number_option.hpp"

namespace wavecurve::tools {

namespace {

constexpr double most_frames = 100000;  ///< of frames_check

/// An opaque colour of CSS; none for another text.
std::optional<Colour> opaque_colour(const std::string& text) {
  const auto colour = io::parse_css_colour(text);
  return colour && colour->opacity == 1 ? std::optional(colour->colour) : std::nullopt;
}

CLI::Validator background_check() {
  return {[](const std::string& text) {
            return text == "none" || opaque_colour(text)
                       ? std::string()
                       : value_text(std::string_view(text)) +
                             " is not an opaque colour of CSS, or none";
          },
          "COLOR|none", "background"};
}

}  // namespace

void AnimationOutput::add_to(CLI::App* command, const std::string& default_frames) {
  command
      ->add_option("-o,--output", path_,
                   "Output; its extension selects the format: " + io::animation_endings())
      ->required();
  CLI::Option* frames =
      command->add_option("--frames", frames_, "Number of frames; " + default_frames);
  frames->check(frames_check());
  CLI::Option* rate = command->add_option(
      "--fps", rate_,
      "Frames a second, instead of their number; the duration is rounded to whole frames");
  rate->check(number_from(0.01, 1000))->excludes(frames);
  CLI::Option* size = command->add_option(
      "--size", size_,
      "Width and height in pixels; the drawing is centred, as large as fits. By default its longer side "
      "has 512");
  size->check(size_check());
  command
      ->add_option(
          "--background", background_,
          "Colour behind the drawing, or none; by default white in .gif, .mp4 and .webm, none in "
          "other formats")
      ->check(background_check());
  command
      ->add_option(
          "--tolerance", tolerance_,
          "Maximum distance of the written curves from the exact ones, in drawing units; by "
          "default a tenth of a pixel. 0 writes polygons of all points, and all keys")
      ->check(tolerance_check());
  sheet_ = command->add_flag("--sheet", is_sheet_, "Write the frames as one picture");
  sheet_->excludes(size, rate);
}

std::string AnimationOutput::ending() const {
  return std::filesystem::path(path_).extension().string();
}

void AnimationOutput::check() const {
  if (is_sheet_ && !path_.ends_with(".svg")) {
    throw std::invalid_argument(must_be("the file of a sheet", path_, "an .svg"));
  }
  if (tolerance_.value_or(0) > 0 && !io::holds_curves(path_)) {
    throw std::invalid_argument(fmt::format(
        "--tolerance is for formats that hold curves, such as .svg, not for {}", ending()));
  }
  if (background_ == "none" && ending() == ".mp4") {
    throw std::invalid_argument(
        "--background none is not for .mp4, which has no transparency; .webm has");
  }
  if (size_.empty()) return;
  if (ending() == ".html") {
    throw std::invalid_argument("--size is not for .html, which is as large as its window");
  }
  const auto [width, height] = *parsed_size(size_);
  const bool is_video = ending() == ".mp4" || ending() == ".webm";
  if (is_video && (width % 2 != 0 || height % 2 != 0)) {
    throw std::invalid_argument(
        must_be("the size of an " + ending(), size_, "two even numbers, as its codec wants them"));
  }
}

int AnimationOutput::steps(double seconds) const {
  const double steps = std::round(seconds * *rate_);
  if (steps < 1) {
    throw std::invalid_argument(
        fmt::format("--fps {} has no second frame in {} seconds", *rate_, seconds));
  }
  if (steps < most_frames) return static_cast<int>(steps);
  throw std::invalid_argument(fmt::format("--fps {} makes {} frames in {} seconds; at most {}",
                                          *rate_, steps, seconds, most_frames));
}

io::OutputOptions AnimationOutput::options(const ViewBox& box) const {
  io::OutputOptions options;
  if (!size_.empty()) {
    const auto [width, height] = *parsed_size(size_);
    options.size = {width, height};
  }
  options.transparent = background_ == "none";
  options.background = opaque_colour(background_);
  options.tolerance = tolerance_.value_or(io::usual_tolerance(path_, box, options));
  return options;
}

}  // namespace wavecurve::tools
