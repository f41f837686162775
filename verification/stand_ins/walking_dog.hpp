#pragma once

#include "wavecurve/motion/gait/walk/gait_animation.hpp"

#include "verification/stand_ins/frame_sheet.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification {

/// The drawing docs/examples/dog.svg, walking by the publication's cycle: subcycles A to D, from
/// two key frames of example_walk() and its gammas.
gait::GaitAnimation walking_dog(int frames, std::optional<Eigen::Index> scale = std::nullopt);

/// Its numbers: stride, and how far standing feet slide.
Table walk_numbers(const gait::GaitAnimation& walk, int frames);

/// What the figures of the walk say about their data.
extern const std::string walk_data;

/// `count` frames of it, from one on.
SheetRow sheet_row(const gait::GaitAnimation& walk, const std::string& label, int first, int count);

}  // namespace wavecurve::verification
