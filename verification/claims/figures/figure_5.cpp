// Figure 5 sets linear morphing beside physically based motion with several parameters. The
// publication's shapes are lost; the dog and the cat of docs/examples stand in for them.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/animations/animation_sheet.hpp"
#include "wavecurve/motion/morph/make_morph.hpp"
#include "wavecurve/motion/morph/physical_motion.hpp"

#include "verification/stand_ins/example_drawing.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification::figure_5 {

namespace {

constexpr int shown_frames = 12, measured_frames = 61;

struct Motion {
  std::string name;
  dynamics::Material material;
};

const std::vector<Motion> motions{
    {"lively", motion::lively_material},
    {"heavy", {.density = 4, .stiffness_damping = 0.1}},
    {"stiff and damped", {.stiffness = 4, .stiffness_damping = 0.2}},
};

motion::Morph face_morph() {
  const motion::MorphOptions options{.bank = find_filter_bank("bspline4.4"), .samples = 256};
  return motion::make_morph(example_drawing("face-dog.svg"), example_drawing("face-cat.svg"),
                            options);
}

/// All for the same time, in which the first one settles.
motion::Animation physical(const motion::Morph& morph, const dynamics::Material& material,
                           int frames) {
  motion::PhysicalOptions options{.material = material};
  options.until = motion::settling_time(morph, motions[0].material);
  options.frames = frames;
  return motion::physical_animation(morph, options);
}

/// The linear one with a key for every frame, as the others have.
motion::Animation linear(const motion::Morph& morph, int frames) {
  const motion::Animation straight = motion::animate(morph);
  motion::Animation result = straight;
  for (std::size_t k = 0; k < straight.layers.size(); ++k) {
    result.layers[k].outline.clear();
    for (int i = 0; i < frames; ++i) {
      const double time = straight.duration * i / (frames - 1);
      result.layers[k].outline.push_back(
          {time, motion::layer_at(straight.layers[k], time).contours});
    }
  }
  return result;
}

/// Four animations as one, in two rows of two.
motion::Animation side_by_side(const std::vector<motion::Animation>& animations) {
  constexpr double room = 1.1;  // for what swings over the border
  const ViewBox box = animations[0].view_box;
  motion::Animation all{
      {box.x, box.y, (1 + room) * box.width, (1 + room) * box.height}, animations[0].duration, {}};
  for (std::size_t i = 0; i < animations.size(); ++i) {
    const Eigen::RowVector2d shift(static_cast<double>(i % 2) * room * box.width,
                                   static_cast<double>(i / 2) * room * box.height);
    for (motion::AnimatedLayer layer : animations[i].layers) {
      layer.id += fmt::format("-{}", i + 1);
      for (motion::OutlineKey& key : layer.outline) {
        for (Contour& contour : key.contours) contour.rowwise() += shift;
      }
      all.layers.push_back(std::move(layer));
    }
  }
  return all;
}

/// How a motion goes, of all contours of the drawing.
struct Course {
  double overshoot =
      0;             ///< how far the displacement overshoots, but for means, as a share of itself
  double speed = 0;  ///< the largest of a point, in widths of the drawing per duration
  double left = 0;   ///< the largest distance at the end, in widths
};

/// The displacements of all contours in a key.
std::vector<Contour> displacements(const motion::Animation& animation, std::size_t key,
                                   const motion::Animation& destination) {
  std::vector<Contour> all;
  for (std::size_t k = 0; k < animation.layers.size(); ++k) {
    const auto& now = animation.layers[k].outline[key].contours;
    const auto& end = destination.layers[k].outline.back().contours;
    for (std::size_t c = 0; c < now.size(); ++c) all.push_back(now[c] - end[c]);
  }
  return all;
}

/// Means, which move in straight lines, left out.
double product(const std::vector<Contour>& a, const std::vector<Contour>& b) {
  double sum = 0;
  for (std::size_t c = 0; c < a.size(); ++c) {
    const Eigen::RowVector2d mean = a[c].colwise().mean();
    sum += (a[c].rowwise() - mean).cwiseProduct(b[c]).sum();
  }
  return sum;
}

double largest_distance(const std::vector<Contour>& a, const std::vector<Contour>& b) {
  double largest = 0;
  for (std::size_t c = 0; c < a.size(); ++c) {
    largest = std::max(largest, (a[c] - b[c]).rowwise().norm().maxCoeff());
  }
  return largest;
}

Course course(const motion::Animation& animation, const motion::Animation& destination) {
  const double width = animation.view_box.width;
  const auto start = displacements(animation, 0, destination);
  auto last = start;
  Course result;
  for (std::size_t key = 1; key < measured_frames; ++key) {
    auto now = displacements(animation, key, destination);
    result.overshoot = std::max(result.overshoot, -product(now, start) / product(start, start));
    const double speed = largest_distance(now, last) * (measured_frames - 1) / width;
    result.speed = std::max(result.speed, speed);
    last = std::move(now);
  }
  const auto end = displacements(destination, measured_frames - 1, destination);
  result.left = largest_distance(last, end) / width;
  return result;
}

/// To three digits; what is rounding is 0.
std::string digits(double value) { return value < 1e-9 ? "0" : fmt::format("{:.3g}", value); }

std::vector<std::string> row(const std::string& name, const std::vector<std::string>& constants,
                             const Course& how) {
  std::vector<std::string> cells{name};
  cells.insert(cells.end(), constants.begin(), constants.end());
  for (const double value : {how.overshoot, how.speed, how.left}) cells.push_back(digits(value));
  return cells;
}

Outcome evaluate() {
  const motion::Morph morph = face_morph();
  const motion::Animation straight = linear(morph, measured_frames);
  Picture picture;
  picture.id = "figure-5";
  picture.data = {
      "Swing-over of the shapes as a share of the displacement; the largest speed of a point in "
      "widths of the drawing per duration; the largest distance left at the end in "
      "widths; settling times in units of the time of the motion",
      {"motion", "e_0", "rho", "s_2", "settles by", "overshoot", "speed", "left"},
      {row("linear", {"-", "-", "-", "-"}, course(straight, straight))}};
  std::vector<motion::Animation> shown{linear(morph, shown_frames)};
  double overshoot = 0;
  for (const auto& [name, material] : motions) {
    const Course how = course(physical(morph, material, measured_frames), straight);
    overshoot = std::max(overshoot, how.overshoot);
    picture.data.rows.push_back(
        row(name,
            {digits(material.stiffness), digits(material.density),
             digits(material.stiffness_damping), digits(motion::settling_time(morph, material))},
            how));
    shown.push_back(physical(morph, material, shown_frames));
  }
  const motion::Animation all = side_by_side(shown);
  picture.alternative_text = fmt::format(
      "{} frames of four motions of the face of a dog into that of a cat; in each frame linear at "
      "the upper left, then {}, {}, and {}",
      shown_frames, motions[0].name, motions[1].name, motions[2].name);
  io::OutputOptions options;
  options.frames = shown_frames;
  options.tolerance = all.view_box.width / 1024;
  picture.svg = io::animation_sheet(all, options);
  return {ClaimVerdict::stand_in,
          {"linear and {} physical motions; the largest overshoot is {} of the way",
           {counted("physical motions", std::ssize(motions)),
            to_digits("largest overshoot as a share of the way", overshoot, 3)}},
          "The publication's drawings and parameters are lost; faces of our own move linearly and "
          "as elastic curves with other constitutive, mass and damping parameters.",
          {picture}};
}

const RegisterClaim registered(
    {"figure-5", "Linear morphing beside physically based motion", "Section 4.2, Figure 5",
     "Comparison of the conventional linear morphing to physically-based motion with different "
     "parameters.",
     evaluate});

}  // namespace

}  // namespace wavecurve::verification::figure_5
