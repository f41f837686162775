#include "wavecurve/motion/morph/avoid_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "wavecurve/curves/crossings.hpp"
#include "wavecurve/motion/morph/contour_morph.hpp"
#include "wavecurve/motion/morph/detail/pair_contours.hpp"

namespace wavecurve::motion {

namespace {

using Eigen::Index;

/// Frames of a layer, and their crossings.
class LayerFrames {
 public:
  LayerFrames(const Morph& morph, const MorphLayer& layer, Index scale, double stage_share)
      : layer_(layer), detail_(morph.detail), stage_share_(stage_share) {
    for (const ContourPair& pair : layer.contours) {
      contours_.emplace_back(morph.bank, pair.source.rows(), morph.levels, scale);
      points_.emplace_back(pair.source.rows(), 2);
      contours_.back().frame(pair, 0, {1, 0}, points_.back());
      const bool starts_as_stroke = is_there_and_back(points_.back());
      contours_.back().frame(pair, 1, {0, 1}, points_.back());
      is_stroke_.push_back(starts_as_stroke && is_there_and_back(points_.back()));
    }
  }

  Index crossings(double tau) {
    const DetailShares shares = detail_shares(detail_, stage_share_, tau);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      contours_[i].frame(layer_.contours[i], tau, shares, points_[i]);
    }
    Index count = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (is_stroke_[i]) {
        count += count_crossings(points_[i].topRows(points_[i].rows() / 2 + 1), Closing::open);
        continue;
      }
      count += count_crossings(points_[i]);
      for (std::size_t j = 0; j < i; ++j) {
        if (!is_stroke_[j]) count += count_crossings(points_[i], points_[j]);
      }
    }
    return count;
  }

 private:
  const MorphLayer& layer_;
  Detail detail_;
  double stage_share_;
  std::vector<ContourMorph> contours_;
  std::vector<Contour> points_;
  std::vector<bool> is_stroke_;
};

/// The sum over all times, or any number from `enough` on once it has reached that.
Index total_crossings(LayerFrames& frames, const std::vector<double>& taus, Index enough) {
  Index total = 0;
  for (std::size_t i = 0; i < taus.size() && total < enough; ++i) {
    total += frames.crossings(taus[i]);
  }
  return total;
}

/// Scales from fine to coarse, from the layer's own on, that give different frames.
std::vector<Index> scales(const Morph& morph, const MorphLayer& layer) {
  std::vector<Index> found{layer.scale};
  if (layer.contours.empty() || morph.detail == Detail::blend) return found;
  const Index coarsest = layer.contours[0].source.rows() >> morph.levels;
  while (found.back() / 2 >= coarsest) found.push_back(found.back() / 2);
  return found;
}

ScaleChoice best_scale(const std::vector<Morph>& alternatives, std::size_t place,
                       double stage_share, const std::vector<double>& taus) {
  ScaleChoice best{alternatives[0].layers[place].id, 0, 0, std::numeric_limits<Index>::max()};
  for (const Index scale : scales(alternatives[0], alternatives[0].layers[place])) {
    for (std::size_t a = 0; a < alternatives.size(); ++a) {
      LayerFrames frames(alternatives[a], alternatives[a].layers[place], scale, stage_share);
      const Index count = total_crossings(frames, taus, best.crossings);
      if (count < best.crossings) best = {best.layer, scale, a, count};
      if (count == 0) return best;
    }
  }
  return best;
}

Index sum(const std::vector<ScaleChoice>& choices) {
  Index total = 0;
  for (const ScaleChoice& choice : choices) total += choice.crossings;
  return total;
}

/// Most crossings are half-way: a candidate that is no better is soon dropped.
std::vector<double> from_the_middle(std::vector<double> taus) {
  std::stable_sort(taus.begin(), taus.end(),
                   [](double a, double b) { return std::abs(a - 0.5) < std::abs(b - 0.5); });
  return taus;
}

ChosenMorph chosen(const std::vector<Morph>& alternatives, std::vector<ScaleChoice> choices,
                   double stage_share) {
  ChosenMorph result{alternatives[0], std::move(choices)};
  result.morph.stage_share = stage_share;
  for (std::size_t i = 0; i < result.choices.size(); ++i) {
    const ScaleChoice& choice = result.choices[i];
    result.morph.layers[i] = alternatives[choice.alternative].layers[i];
    result.morph.layers[i].scale = choice.scale;
  }
  return result;
}

}  // namespace

std::vector<Index> crossings(const Morph& morph, const MorphLayer& layer,
                             const std::vector<double>& taus) {
  LayerFrames frames(morph, layer, layer.scale, morph.stage_share);
  std::vector<Index> counts;
  for (const double tau : taus) counts.push_back(frames.crossings(tau));
  return counts;
}

ChosenMorph avoid_crossings(const std::vector<Morph>& alternatives, const std::vector<double>& taus,
                            const std::function<void(std::size_t, std::size_t)>& progress) {
  if (alternatives.empty()) throw std::invalid_argument("there is no morph to choose from");
  const std::vector<double> ordered = from_the_middle(taus);
  const std::size_t layers = alternatives[0].layers.size();
  const int halvings = alternatives[0].detail == Detail::stage ? 5 : 0;
  double stage_share = alternatives[0].stage_share, best_share = stage_share;
  std::vector<ScaleChoice> best;
  for (int halving = 0; halving <= halvings; ++halving, stage_share /= 2) {
    std::vector<ScaleChoice> choices;
    for (std::size_t i = 0; i < layers; ++i) {
      choices.push_back(best_scale(alternatives, i, stage_share, ordered));
      if (progress) progress(i + 1, layers);
    }
    if (halving > 0 && sum(choices) >= sum(best)) continue;
    best = std::move(choices);
    best_share = stage_share;
    if (sum(best) == 0) break;
  }
  return chosen(alternatives, std::move(best), best_share);
}

}  // namespace wavecurve::motion
