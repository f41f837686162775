// Figure 13 shows the synthesised walk in subcycle A, in more frames. The video is lost; the dog of
// docs/examples stands in.
#include <string>

#include <fmt/format.h>

#include "verification/stand_ins/example_gait.hpp"
#include "verification/stand_ins/walking_dog.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification::figure_13 {

namespace {

constexpr int columns = 6, rows_of_frames = 3;

Outcome evaluate() {
  constexpr int count = rows_of_frames * columns;
  const gait::GaitAnimation walk = walking_dog(4 * count);
  std::vector<SheetRow> rows;
  for (int i = 0; i < rows_of_frames; ++i) {
    rows.push_back(
        sheet_row(walk, fmt::format("A, {}/{}", i, rows_of_frames), i * columns, columns));
  }
  Picture picture;
  picture.id = "figure-13";
  picture.svg = frame_sheet(rows, {}, {0, 0, 360, 260}, example_ground);
  picture.alternative_text = fmt::format(
      "{} frames of subcycle A of a drawn dog that walks to the right: the left forelimb swings to "
      "the front.",
      count);
  picture.data = walk_numbers(walk, 4 * count);
  return {ClaimVerdict::stand_in,
          {"{} frames of subcycle A, between one pair of key frames", {counted("frames", count)}},
          walk_data + " Any number of frames may be drawn between two key frames.",
          {picture, quality_table({"stance", "swing"}, {gait::GaitModel::quadratic})}};
}

const RegisterClaim registered(
    {"figure-13", "The synthesised walk, subcycle A", "Section 4.2, Figure 13",
     "The synthesized locomotion of a dog. Only frames in Subcycle A are shown.", evaluate});

}  // namespace

}  // namespace wavecurve::verification::figure_13
