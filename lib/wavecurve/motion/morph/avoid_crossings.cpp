#include "wavecurve/motion/morph/avoid_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "wavecurve/curves/crossings.hpp"
#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/motion/morph/contour_morph.hpp"

namespace wavecurve::motion {

namespace {

using Eigen::Index;

double extent(const Contour& points) {
  return (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
}

/// A contour of a layer in its frames.
struct MovingContour {
  MovingContour(const Morph& of, const ContourPair& both, Index scale)
      : morph(of.bank, both.source.rows(), of.levels, scale),
        pair(both),
        points(both.source.rows(), 2) {
    for (const double end : {0.0, 1.0}) {
      morph.frame(pair, end, {1 - end, end}, points);
      largest_extent = std::max(largest_extent, extent(points));
      area += signed_area(points);
    }
  }

  /// Where an outline is a point, its edges are roundings.
  bool is_point() const { return extent(points) <= 1e-9 * largest_extent; }
  bool is_hole() const { return area < 0; }

  ContourMorph morph;
  const ContourPair& pair;
  Contour points;
  double largest_extent = 0, area = 0;  ///< the area is the sum of both ends'
};

/// Frames of a layer, and their crossings.
class LayerFrames {
 public:
  LayerFrames(const Morph& morph, const MorphLayer& layer, Index scale, double stage_share)
      : detail_(morph.detail), stage_share_(stage_share) {
    for (const ContourPair& pair : layer.contours) contours_.emplace_back(morph, pair, scale);
  }

  Index crossings(double tau) {
    const DetailShares shares = detail_shares(detail_, stage_share_, tau);
    for (MovingContour& contour : contours_) {
      contour.morph.frame(contour.pair, tau, shares, contour.points);
    }
    Index count = 0;
    for (std::size_t i = 0; i < contours_.size(); ++i) {
      const MovingContour& a = contours_[i];
      if (a.is_point()) continue;
      if (a.pair.open) {
        count += count_crossings(a.points.topRows(a.points.rows() / 2 + 1), Closing::open);
        continue;
      }
      count += count_crossings(a.points);
      for (std::size_t j = 0; j < i; ++j) {
        const MovingContour& b = contours_[j];
        if (b.pair.open || b.is_point() || (!a.is_hole() && !b.is_hole())) continue;
        count += count_crossings(a.points, b.points);
      }
    }
    return count;
  }

 private:
  Detail detail_;
  double stage_share_;
  std::vector<MovingContour> contours_;
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

/// The finest scale without crossings; where none is, the layer's own with the fewest.
ScaleChoice best_scale(const std::vector<Morph>& alternatives, std::size_t place,
                       double stage_share, const std::vector<double>& taus) {
  const std::vector<Index> from_own_on = scales(alternatives[0], alternatives[0].layers[place]);
  ScaleChoice best{alternatives[0].layers[place].id, 0, 0, std::numeric_limits<Index>::max()};
  for (const Index scale : from_own_on) {
    const bool is_own = scale == from_own_on.front();
    for (std::size_t a = 0; a < alternatives.size(); ++a) {
      LayerFrames frames(alternatives[a], alternatives[a].layers[place], scale, stage_share);
      const Index count = total_crossings(frames, taus, is_own ? best.crossings : 1);
      if (count == 0 || (is_own && count < best.crossings)) best = {best.layer, scale, a, count};
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
