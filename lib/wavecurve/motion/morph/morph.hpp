#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/motion/animation.hpp"

namespace wavecurve::motion {

/// What becomes of the details, the wavelet coefficients finer than the scale of the morph.
enum class Detail {
  drop,   ///< none in any frame, nor at the ends: the publication's morph
  blend,  ///< interpolated as the control points are: both ends exact
  stage,  ///< those of the source fade out, then those of the destination fade in: both ends exact
};

/// Corresponding contours as coefficients in global-to-local order, one a row, columns x and y.
/// Row n of one corresponds to row n of the other. Publication, (2.10)-(2.12). An open line is run
/// through there and back; its outline in an animation is the way there alone.
struct ContourPair {
  Contour source, destination;
  bool open = false;
};

/// A layer of the morph, and its scale: the number of control points that are interpolated, a power
/// of two; everything finer is detail.
struct MorphLayer {
  std::string id;
  std::vector<ContourPair> contours;
  std::vector<PaintKey> paint;
  Eigen::Index scale = 0;
};

/// A linear morph (4.1): coarse coefficients (1 - tau) A^s + tau A^d, tau = time / duration.
struct Morph {
  ViewBox view_box;
  FilterBank<double> bank;
  int levels = 0;  ///< of the transform of every contour
  Detail detail = Detail::blend;
  double stage_share = 0.25;  ///< of the duration, that the details take to fade out, and in
  double duration = 1;        ///< seconds
  std::vector<MorphLayer> layers;
  std::vector<OrderKey> order = {};  ///< as in Animation
};

/// Which contours of a layer are open, as an animation has it.
std::vector<bool> open_contours(const MorphLayer& layer);

/// The part of a frame's points that is an outline: all, or of an open line the way there.
inline auto outline_rows(const ContourPair& pair, Contour& points) {
  return points.topRows(pair.open ? points.rows() / 2 + 1 : points.rows());
}

/// The morph as outlines. It is piecewise linear in time: two keys a layer, four with
/// Detail::stage. Throws std::invalid_argument naming the layer whose scale is not of its
/// transform, or the share of a stage outside (0, 0.5].
Animation animate(const Morph& morph);

}  // namespace wavecurve::motion
