#include "tools/commands/output/crossings_table.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "wavecurve/filters/detail/characters.hpp"

namespace wavecurve::tools {

namespace {

std::size_t longest_id(const motion::Morph& morph) {
  std::size_t longest = std::string("layer").size();
  for (const motion::MorphLayer& layer : morph.layers) {
    longest = std::max(longest, printable(layer.id).size());
  }
  return longest;
}

std::string frames_text(const std::vector<Eigen::Index>& counts) {
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] != 0) text += fmt::format(" {}:{}", i + 2, counts[i]);
  }
  return text;
}

}  // namespace

std::string crossings_table(const motion::Morph& morph, const std::vector<double>& taus) {
  const std::size_t width = longest_id(morph);
  std::string text =
      fmt::format("{:<{}}  {:>5}  {:>9}  in frames\n", "layer", width, "scale", "crossings");
  Eigen::Index all = 0;
  for (const motion::MorphLayer& layer : morph.layers) {
    const std::vector<Eigen::Index> counts = motion::crossings(morph, layer, taus);
    const Eigen::Index sum = std::accumulate(counts.begin(), counts.end(), Eigen::Index{0});
    text += fmt::format("{:<{}}  {:>5}  {:>9} {}\n", printable(layer.id), width, layer.scale, sum,
                        frames_text(counts));
    all += sum;
  }
  return text + fmt::format("{} crossings in {} frames between the drawings\n", all, taus.size());
}

std::string choices_table(const motion::ChosenMorph& chosen) {
  const std::size_t width = longest_id(chosen.morph);
  std::string text =
      fmt::format("{:<{}}  {:>5}  {:>9}  {}\n", "layer", width, "scale", "crossings", "start");
  for (const motion::ScaleChoice& choice : chosen.choices) {
    text += fmt::format("{:<{}}  {:>5}  {:>9}  {}\n", printable(choice.layer), width, choice.scale,
                        choice.crossings, choice.alternative == 0 ? "as asked" : "rotation aside");
  }
  const auto crosses = [](const motion::ScaleChoice& choice) { return choice.crossings > 0; };
  if (std::any_of(chosen.choices.begin(), chosen.choices.end(), crosses)) {
    text += "no scale and start avoids all crossings: where some are left, the scale is as asked\n";
  }
  if (chosen.morph.detail == motion::Detail::stage) {
    text += fmt::format("details fade in the first and last {:.3g} of the time\n",
                        chosen.morph.stage_share);
  }
  return text;
}

}  // namespace wavecurve::tools
