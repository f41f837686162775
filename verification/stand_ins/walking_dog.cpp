#include "verification/stand_ins/walking_dog.hpp"

#include <fmt/format.h>

#include "wavecurve/filters/find_filter_bank.hpp"

#include "verification/stand_ins/example_drawing.hpp"
#include "verification/stand_ins/example_gait.hpp"
#include "verification/suite/claim_value.hpp"

namespace wavecurve::verification {

gait::GaitAnimation walking_dog(int frames, std::optional<Eigen::Index> scale) {
  gait::GaitAnimationOptions options;
  options.bank = find_filter_bank<double>("bspline4.4");
  options.subcycles = true;
  options.frames = frames;
  options.scale = scale;
  return gait::animate_gait(example_gait().parameters, example_drawing("dog.svg"), options);
}

Table walk_numbers(const gait::GaitAnimation& walk, int frames) {
  return {"The walk that is shown; shares of the stride",
          {"frames a cycle", "stride", "a standing foot slides", "before it is held to the ground",
           "a standing foot is off the ground by"},
          {{std::to_string(frames), fmt::format("{:.1f}", walk.stride), percent(walk.slide) + " %",
            percent(walk.slide_before) + " %", percent(walk.lift) + " %"}}};
}

const std::string walk_data =
    "The video is lost. The motion is that of docs/examples/dog-walk.csv, fitted by the "
    "publication's quadratic between two key frames; it drives the drawing docs/examples/dog.svg.";

SheetRow sheet_row(const gait::GaitAnimation& walk, const std::string& label, int first,
                   int count) {
  SheetRow row{label, {}};
  const motion::Animation& animation = walk.animation;
  const auto& keys = animation.layers.at(0).outline;
  for (int i = first; i < first + count; ++i) {
    row.frames.push_back(motion::frame_at(animation, keys.at(static_cast<std::size_t>(i)).time));
  }
  return row;
}

}  // namespace wavecurve::verification
