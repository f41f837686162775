#include "wavecurve/motion/morph/morph.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/motion/morph/contour_morph.hpp"

namespace wavecurve::motion {

namespace {

/// Between these normalised times every frame is linear in time.
std::vector<double> knots(const Morph& morph) {
  if (morph.detail != Detail::stage) return {0, 1};
  const double share = morph.stage_share;
  check_stage_share(share);
  if (share == 0.5) return {0, 0.5, 1};
  return {0, share, 1 - share, 1};
}

std::vector<OutlineKey> outline_keys(const Morph& morph, const MorphLayer& layer,
                                     const std::vector<double>& times) {
  std::vector<OutlineKey> keys(times.size());
  for (std::size_t k = 0; k < times.size(); ++k) keys[k].time = times[k] * morph.duration;
  for (const ContourPair& pair : layer.contours) {
    ContourMorph contour(morph.bank, pair.source.rows(), morph.levels, layer.scale);
    for (std::size_t k = 0; k < times.size(); ++k) {
      Contour points(pair.source.rows(), 2);
      contour.frame(pair, times[k], detail_shares(morph.detail, morph.stage_share, times[k]),
                    points);
      keys[k].contours.emplace_back(outline_rows(pair, points));
    }
  }
  return keys;
}

}  // namespace

std::vector<bool> open_contours(const MorphLayer& layer) {
  std::vector<bool> open;
  for (const ContourPair& pair : layer.contours) open.push_back(pair.open);
  return open;
}

Animation animate(const Morph& morph) {
  const std::vector<double> times = knots(morph);
  Animation animation{morph.view_box, morph.duration, {}, morph.order};
  for (const MorphLayer& layer : morph.layers) {
    try {
      animation.layers.push_back(
          {layer.id, outline_keys(morph, layer, times), layer.paint, open_contours(layer)});
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("layer '{}': {}", layer.id, error.what()));
    }
  }
  return animation;
}

}  // namespace wavecurve::motion
