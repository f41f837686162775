#pragma once

#include <string>

#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/motion/morph/morph.hpp"

namespace wavecurve::io {

/// A page that plays the animation: play, pause, scrub, speed, repetition, by mouse and keyboard.
/// It holds everything it needs. Throws as check_animation does.
std::string html_player(const motion::Animation& animation, const OutputOptions& options = {});

/// A page that also lets the viewer choose the scale and what becomes of the details: it holds the
/// coefficients and the taps, and does the inverse transform itself. With a tolerance, details too small
/// to matter are left out: those of one end move its curve by at most so much. Throws as animate does.
std::string html_player(const motion::Morph& morph, const OutputOptions& options = {});

}  // namespace wavecurve::io
