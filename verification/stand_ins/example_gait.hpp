#pragma once

#include <array>
#include <string>
#include <vector>

#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/motion/animation.hpp"
#include "wavecurve/motion/gait/model/fit_gait.hpp"

#include "verification/suite/claim.hpp"

namespace wavecurve::verification {

/// The walk of docs/examples/dog-walk.csv, which stands in for the publication's video.
const gait::LimbTracks& example_walk();

/// All models fitted to it, at the finest scale, in the filter `bspline4.4`. Computed once.
const gait::GaitFit& example_gait();

/// The publication's key frames 1 and 2 in that record.
std::array<double, 2> example_key_frames();

/// A frame of the record: the drawing docs/examples/dog.svg with the recorded outlines as its
/// limbs.
std::vector<motion::FrameLayer> recorded_frame(std::size_t frame);

/// The height in docs/examples/dog.svg where its feet stand.
constexpr double example_ground = 232;

/// Residuals and cross-validated errors, as shares of the stride in %, of limbs by phases and
/// models: what all figures of the gait have beneath.
Table quality_table(const std::vector<std::string>& phases,
                    const std::vector<gait::GaitModel>& models);

}  // namespace wavecurve::verification
