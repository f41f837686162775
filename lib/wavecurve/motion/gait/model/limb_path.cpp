#include "wavecurve/motion/gait/model/limb_path.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve::gait {

namespace {

/// A span with its neighbours, cyclic.
struct Place {
  std::size_t span = 0;
  double tau = 0;
};

Place find_place(const LimbPath& path, double u) {
  double rest = u - path.offset;
  rest -= std::floor(rest);
  for (std::size_t i = 0; i < path.spans.size(); ++i) {
    const double share = path.spans[i].share;
    // The last one takes what the rounding of the sum of shares leaves.
    if (rest < share || i + 1 == path.spans.size()) return {i, std::min(rest / share, 1.0)};
    rest -= share;
  }
  throw std::invalid_argument(fmt::format("the path of limb '{}' has no spans", path.limb));
}

const PathSpan& following(const LimbPath& path, std::size_t span) {
  return path.spans[(span + 1) % path.spans.size()];
}

/// By the share of the cycle, at the start (tau 0) or the end (tau 1) of a span.
Contour speed(const LimbPath& path, std::size_t span, double tau) {
  const PathSpan& here = path.spans[span];
  return velocity_between(here.motion, here.start, following(path, span).start, tau) / here.share;
}

/// The change of speed at the start of a span that makes both sides of the seam equal their mean.
Contour half_jump(const LimbPath& path, std::size_t span) {
  const std::size_t before = (span + path.spans.size() - 1) % path.spans.size();
  return (speed(path, before, 1) - speed(path, span, 0)) / 2;
}

}  // namespace

LimbPath path_of_point(const LimbPath& path, Eigen::Index point) {
  LimbPath result{path.limb, 0, path.offset, {}};
  for (const PathSpan& span : path.spans) {
    PathSpan part = span;
    part.start = span.start.row(point);
    const Eigen::MatrixXd& all = span.motion.parameters;
    part.motion.parameters.resize(all.rows(), 2);
    if (all.rows() > 0) {
      part.motion.parameters << all.col(point), all.col(span.start.rows() + point);
    }
    result.spans.push_back(std::move(part));
  }
  return result;
}

Contour pose_at(const LimbPath& path, double u, Continuity continuity) {
  const Place place = find_place(path, u);
  const PathSpan& here = path.spans[place.span];
  const std::size_t next = (place.span + 1) % path.spans.size();
  const double tau = place.tau;
  Contour pose = pose_between(here.motion, here.start, path.spans[next].start, tau);
  if (continuity == Continuity::velocity) {
    // Hermite's cubics: slope 1 at one end, no value at either.
    pose += here.share * (tau * (1 - tau) * (1 - tau) * half_jump(path, place.span) +
                          tau * tau * (1 - tau) * half_jump(path, next));
  }
  return pose;
}

}  // namespace wavecurve::gait
