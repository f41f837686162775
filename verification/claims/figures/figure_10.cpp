// Figure 10 lays the limbs of all frames of subcycle A over each other, from key frame 1 to key
// frame 2. The video is lost; the walk of docs/examples/dog-walk.csv stands in for it.
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "wavecurve/io/animations/detail/control_points.hpp"
#include "wavecurve/motion/gait/record/gait_cycle.hpp"

#include "verification/stand_ins/example_gait.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification::figure_10 {

namespace {

constexpr std::string_view between =
    "stroke=\"#888888\" stroke-width=\"0.7\" "
    "stroke-dasharray=\"0.1 2\" stroke-linecap=\"round\"";
constexpr std::string_view first =
    "stroke=\"#b3541e\" stroke-width=\"1.3\" "
    "stroke-dasharray=\"5 3\"";
constexpr std::string_view second = "stroke=\"#1f5a96\" stroke-width=\"1.5\"";

std::string outline_svg(const Contour& outline, std::string_view style) {
  return fmt::format("<path fill=\"none\" {} d=\"{}\"/>\n", style,
                     io::path_data({outline}, false, io::Decimals(2)));
}

std::string legend() {
  std::string svg;
  double y = 14;
  for (const auto& [style, text] :
       {std::pair{first, "key frame 1"}, std::pair{between, "frames between"},
        std::pair{second, "key frame 2"}}) {
    svg +=
        fmt::format("<path fill=\"none\" {} d=\"M248 {}h26\"/><text x=\"280\" y=\"{}\">{}</text>\n",
                    style, y - 3, y, text);
    y += 13;
  }
  return svg;
}

Outcome evaluate() {
  const gait::LimbTracks& walk = example_walk();
  const gait::GaitFit& gait = example_gait();
  const auto [begin, end] = example_key_frames();
  Picture picture;
  picture.id = "figure-10";
  picture.data = {fmt::format("Ways from key frame 1, at {:.3f} s, to key frame 2, at {:.3f} s, in "
                              "% of the stride",
                              begin, end),
                  {"limb", "frames between", "way of the foot", "farthest way of a point",
                   "mean way of the points"},
                  {}};
  std::string dotted, keys;
  int frames = 0;
  for (const gait::LimbCycle& limb : gait.cycle.limbs) {
    const auto track =
        std::find_if(walk.limbs.begin(), walk.limbs.end(),
                     [&](const gait::LimbTrack& one) { return one.limb == limb.limb; });
    frames = 0;
    for (Eigen::Index i = 0; i < walk.times.size(); ++i) {
      if (walk.times[i] <= begin || walk.times[i] >= end) continue;
      dotted += outline_svg(track->outlines[static_cast<std::size_t>(i)], between);
      ++frames;
    }
    const Contour from = gait::outline_at(walk.times, *track, begin);
    const Contour to = gait::outline_at(walk.times, *track, end);
    keys += outline_svg(from, first) + outline_svg(to, second);
    const Eigen::VectorXd ways = (to - from).rowwise().norm() / gait.cycle.stride;
    picture.data.rows.push_back({limb.limb, std::to_string(frames), percent(ways[limb.foot]),
                                 percent(ways.maxCoeff()), percent(ways.mean())});
  }
  picture.svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 360 172\" width=\"900\" "
      "height=\"430\" font-family=\"sans-serif\" font-size=\"9\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<g transform=\"translate(0 -72)\"><path d=\"M30 {0}H330\" stroke=\"#888888\" "
      "stroke-width=\"0.7\"/>\n{1}{2}</g>\n{3}</svg>\n",
      example_ground, dotted, keys, legend());
  picture.alternative_text = fmt::format(
      "The outlines of four limbs of a dog over each other: of key frame 1 dashed, of key frame 2 "
      "solid, of the {} frames between dotted.",
      frames);
  Outcome outcome;
  outcome.verdict = ClaimVerdict::stand_in;
  outcome.finding = {"{} frames between the key frames, {} apart",
                     {counted("frames between the key frames", frames),
                      to_decimals("time between the key frames", end - begin, 3, "s")}};
  outcome.summary =
      "The video is lost; the limbs are those of docs/examples/dog-walk.csv. Key frame 1 is where "
      "the left forelimb lifts off, key frame 2 a quarter of a cycle later.";
  outcome.evidence = {picture};
  return outcome;
}

const RegisterClaim registered(
    {"figure-10", "The limbs of all frames in subcycle A", "Section 4.2, Figure 10",
     "Limb positions of all frames in Subcycle A, where dash lines are traced from Key frame 1, "
     "solid lines are traced from Key frame 2, and dot lines are traced from all inbetween frames "
     "which will be used to extract parameters for animation.",
     evaluate});

}  // namespace

}  // namespace wavecurve::verification::figure_10
