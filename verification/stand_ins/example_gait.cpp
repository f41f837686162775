#include "verification/stand_ins/example_gait.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/tracks/read_limb_tracks.hpp"
#include "wavecurve/motion/gait/model/fit_subcycles.hpp"

#include "verification/stand_ins/example_drawing.hpp"
#include "verification/suite/claim_value.hpp"
#include "verification/suite/data_folder.hpp"

namespace wavecurve::verification {

const gait::LimbTracks& example_walk() {
  static const gait::LimbTracks walk =
      io::read_limb_tracks({data_folder() / "examples" / "dog-walk.csv"});
  return walk;
}

const gait::GaitFit& example_gait() {
  static const gait::GaitFit fit = gait::fit_gait(
      example_walk(), {.bank = find_filter_bank<double>("bspline4.4"), .filter = "bspline4.4"});
  return fit;
}

std::array<double, 2> example_key_frames() {
  return gait::automatic_key_frames(example_gait().cycle);
}

std::vector<motion::FrameLayer> recorded_frame(std::size_t frame) {
  static const Drawing dog = example_drawing("dog.svg");
  std::vector<motion::FrameLayer> layers;
  for (const Layer& layer : dog.layers) {
    const gait::LimbTrack* const limb = gait::find_track(example_walk(), layer.id);
    layers.push_back({layer.id,
                      limb ? std::vector{limb->outlines.at(frame)} : sample_layer(layer, 256),
                      layer.paint});
  }
  return layers;
}

Table quality_table(const std::vector<std::string>& phases,
                    const std::vector<gait::GaitModel>& models) {
  const gait::GaitParameters& gait = example_gait().parameters;
  Table table{fmt::format("Root mean squares of the record less the model, in % of the stride of "
                          "{:.1f} units of the drawing: of all cycles, and of cycles that the fit "
                          "left out",
                          gait.stride),
              {"limb", "phase", "model", "residual", "cross-validated", "cycles"},
              {}};
  const auto contains = [](const auto& list, const auto& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
  };
  for (const gait::FitQuality& one : gait.quality) {
    if (!contains(phases, one.phase) || !contains(models, one.model)) continue;
    table.rows.push_back({one.limb, one.phase, std::string(gait::model_name(one.model)),
                          percent(one.residual_share_of_stride), percent(one.cross_validated),
                          std::to_string(one.cycles)});
  }
  return table;
}

}  // namespace wavecurve::verification
