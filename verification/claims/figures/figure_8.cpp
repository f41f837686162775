// Figure 8 shows the frames of a video, of a dog in a film, that form a gait cycle. The video is
// lost; the walk of docs/examples/dog-walk.csv stands in for it.
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "verification/stand_ins/example_gait.hpp"
#include "verification/stand_ins/frame_sheet.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification::figure_8 {

namespace {

constexpr std::size_t rows = 4, columns = 4;

Outcome evaluate() {
  const gait::LimbTracks& walk = example_walk();
  const gait::GaitCycle& cycle = example_gait().cycle;
  // The cycle in the middle of the record, from a touch-down of LF on.
  const double step = (walk.times.tail(1) - walk.times.head(1)).value() /
                      static_cast<double>(walk.times.size() - 1);
  const auto frames = static_cast<std::size_t>(std::lround(cycle.period / step));
  std::vector<SheetRow> sheet(rows);
  for (std::size_t i = 0; i < rows * columns; ++i) {
    sheet[i / columns].frames.push_back(recorded_frame(frames + i * frames / (rows * columns)));
  }
  Picture picture;
  picture.id = "figure-8";
  picture.svg = frame_sheet(sheet, {}, {0, 0, 360, 260}, example_ground);
  picture.alternative_text = fmt::format(
      "{} frames of one gait cycle of a drawn dog that walks to the right, from left to right and "
      "top to bottom; its limbs are the outlines of the record.",
      rows * columns);
  picture.data = {
      "The record, its units those of the drawing and seconds",
      {"limb", "frames", "points an outline", "touch-down", "duty factor", "fore-aft excursion"},
      {}};
  for (const gait::LimbCycle& limb : cycle.limbs) {
    picture.data.rows.push_back(
        {limb.limb, std::to_string(walk.times.size()),
         std::to_string(walk.limbs[0].outlines[0].rows()), fmt::format("{:.3f}", limb.touch_down),
         fmt::format("{:.3f}", limb.duty_factor), fmt::format("{:.1f}", limb.excursion)});
  }
  Outcome outcome;
  outcome.verdict = ClaimVerdict::stand_in;
  const double duration = (walk.times.tail(1) - walk.times.head(1)).value();
  outcome.finding = {
      "{} frames, {} cycles of {}, stride {}",
      {counted("frames", walk.times.size()), to_decimals("cycles", duration / cycle.period, 2),
       to_decimals("period", cycle.period, 3, "s"), to_decimals("stride", cycle.stride, 1)}};
  outcome.summary =
      "The video is lost. A dog of the project's own walks in its place: "
      "docs/examples/dog-walk.csv, "
      "generated from published timings of the limbs, with feet that stand still on the ground. "
      "Touch-downs and duty factors are counted from reversal to reversal of the foot.";
  outcome.evidence = {picture};
  return outcome;
}

const RegisterClaim registered(
    {"figure-8", "The picture sequence of a gait cycle", "Section 4.2, Figure 8",
     "The picture sequence that forms a gait cycle of an Afghanistan dog from the original clip.",
     evaluate});

}  // namespace

}  // namespace wavecurve::verification::figure_8
