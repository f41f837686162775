#include "wavecurve/motion/morph/contour_morph.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::motion {

using Eigen::Index;

void check_stage_share(double share) {
  if (share > 0 && share <= 0.5) return;
  throw std::invalid_argument(
      must_be("the share of the stage", share, "above 0 and at most 0.5 of the time"));
}

DetailShares detail_shares(Detail detail, double stage_share, double tau) {
  switch (detail) {
    case Detail::drop:
      return {0, 0};
    case Detail::blend:
      return {1 - tau, tau};
    case Detail::stage:
      return {std::max(0.0, 1 - tau / stage_share), std::max(0.0, 1 - (1 - tau) / stage_share)};
  }
  return {};
}

ContourMorph::ContourMorph(const FilterBank<double>& bank, Index samples, int levels, Index scale)
    : transform_(bank, samples, levels),
      scale_(scale),
      coefficients_(samples),
      workspace_(transform_.workspace_size()) {
  for (int l = 0; l <= levels; ++l) {
    if (scale == samples >> l) return;
  }
  throw std::invalid_argument(
      must_be("scale", scale, fmt::format("{} / 2^l for an l from 0 to {}", samples, levels)));
}

void ContourMorph::frame(const ContourPair& pair, double tau, DetailShares shares,
                         Eigen::Ref<Contour> points) {
  const Index samples = transform_.samples(), details = samples - scale_;
  if (pair.source.rows() != samples || pair.destination.rows() != samples ||
      points.rows() != samples) {
    throw std::invalid_argument(
        fmt::format("a pair of contours of {} and {} coefficients, a frame of {} points; all must "
                    "have {}",
                    pair.source.rows(), pair.destination.rows(), points.rows(), samples));
  }
  for (int axis = 0; axis < 2; ++axis) {
    const auto source = pair.source.col(axis), destination = pair.destination.col(axis);
    coefficients_.head(scale_) = (1 - tau) * source.head(scale_) + tau * destination.head(scale_);
    coefficients_.tail(details) =
        shares.source * source.tail(details) + shares.destination * destination.tail(details);
    transform_.inverse(coefficients_, points.col(axis), workspace_);
  }
}

}  // namespace wavecurve::motion
