// Figure 4 morphs a layered cartoon face into another. The publication's faces are lost; the dog
// and the cat of docs/examples stand in for them.
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/animations/animated_svg.hpp"
#include "wavecurve/io/animations/animation_sheet.hpp"
#include "wavecurve/io/animations/detail/control_points.hpp"
#include "wavecurve/io/animations/lottie.hpp"
#include "wavecurve/motion/morph/avoid_crossings.hpp"
#include "wavecurve/motion/morph/make_morph.hpp"

#include "verification/stand_ins/example_drawing.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification::figure_4 {

namespace {

using Eigen::Index;

constexpr int frames = 12;
/// Tolerance of fitted curves, as a share of the view box: a quarter of a pixel of a picture 512 wide.
constexpr double tolerance = 1.0 / 2048;

motion::Morph face_morph(motion::Detail detail, Index scale) {
  motion::MorphOptions options{
      .bank = find_filter_bank("bspline4.4"), .samples = 1024, .scale = scale};
  options.detail = detail;
  return motion::make_morph(example_drawing("face-dog.svg"), example_drawing("face-cat.svg"),
                            options);
}

Index total_crossings(const motion::Morph& morph) {
  std::vector<double> times;
  for (int i = 1; i + 1 < frames; ++i) times.push_back(static_cast<double>(i) / (frames - 1));
  Index total = 0;
  for (const motion::MorphLayer& layer : morph.layers) {
    const std::vector<Index> counts = motion::crossings(morph, layer, times);
    total = std::accumulate(counts.begin(), counts.end(), total);
  }
  return total;
}

/// The vertices of one key of all layers.
Index vertices(const motion::Animation& animation, double fit_tolerance) {
  const io::AnimatedControlPoints points = io::control_points(animation, fit_tolerance);
  Index count = 0;
  for (const motion::AnimatedLayer& layer : points.animation.layers) {
    for (const Contour& contour : layer.outline.front().contours) count += contour.rows();
  }
  return points.cubic ? count / 3 : count;
}

std::vector<std::string> row(const std::string& name, const motion::Morph& morph) {
  const motion::Animation animation = motion::animate(morph);
  io::OutputOptions polygons;
  polygons.frames = frames;
  io::OutputOptions curves = polygons;
  curves.tolerance = tolerance * animation.view_box.width;
  return {name,
          fmt::format("{}", total_crossings(morph)),
          fmt::format("{}", vertices(animation, 0)),
          fmt::format("{}", io::lottie(animation, polygons).size()),
          fmt::format("{}", vertices(animation, curves.tolerance)),
          fmt::format("{}", io::lottie(animation, curves).size()),
          fmt::format("{}", io::animated_svg(animation, curves).size())};
}

Outcome evaluate() {
  const motion::Morph shown = face_morph(motion::Detail::blend, 1024);
  const motion::Animation animation = motion::animate(shown);
  Picture picture;
  picture.id = "figure-4";
  picture.alternative_text = fmt::format(
      "{} frames of the face of a dog that becomes that of a cat, from the upper left "
      "to the lower right; {} layers",
      frames, animation.layers.size());
  io::OutputOptions options;
  options.frames = frames;
  options.tolerance = tolerance * animation.view_box.width;
  picture.svg = io::animation_sheet(animation, options);
  picture.data = {
      fmt::format("The same morph with other details and control points; crossings in {} frames, "
                  "sizes in bytes, curves within 1/2048 of the width",
                  frames - 2),
      {"details", "crossings", "vertices of polygons", "Lottie, polygons", "vertices of curves",
       "Lottie, curves", "SVG, curves"},
      {row("all blended (the figure)", shown),
       row("staged, 64 control points", face_morph(motion::Detail::stage, 64)),
       row("staged, 16 control points", face_morph(motion::Detail::stage, 16)),
       row("dropped, 64 control points (as published)", face_morph(motion::Detail::drop, 64)),
       row("dropped, 16 control points (as published)", face_morph(motion::Detail::drop, 16))}};
  return {ClaimVerdict::stand_in,
          {"{} layers, {} crossings in {} frames",
           {counted("layers", std::ssize(animation.layers)),
            counted("crossings", total_crossings(shown)),
            counted("frames between the ends", frames - 2)}},
          "The publication's drawings are lost; its morph of layers is shown on two faces of our "
          "own. Layers correspond by their names, points by correlation.",
          {picture}};
}

const RegisterClaim registered(
    {"figure-4", "Cartoon morphing of layered faces", "Section 4.1, Figure 4",
     "An example of cartoon morphing by the wavelet descriptor, where the source frame is at the "
     "upper-left corner and the destination frame is the lower-right one.",
     evaluate});

}  // namespace

}  // namespace wavecurve::verification::figure_4
