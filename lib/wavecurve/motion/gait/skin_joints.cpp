#include "wavecurve/motion/gait/skin_joints.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "wavecurve/curves/sample_contour.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;
using Eigen::RowVector2d;

void check(const std::vector<Contour>& joints, double radius) {
  if (joints.empty()) throw std::invalid_argument("0 frames of joints; at least 1 is needed");
  for (const Contour& chain : joints) {
    if (chain.rows() != joints[0].rows() || chain.rows() < 2) {
      throw std::invalid_argument(
          fmt::format("{} joints, and {} in the first frame; as many are needed in all, at least 2",
                      chain.rows(), joints[0].rows()));
    }
    if (!chain.allFinite()) throw std::invalid_argument("the place of a joint is not finite");
  }
  if (!(radius > 0) || !std::isfinite(radius)) {
    throw std::invalid_argument(
        fmt::format("the radius of a limb is {}, but must be positive and finite", radius));
  }
}

Eigen::VectorXd bone_lengths(const Contour& chain) {
  const Index bones = chain.rows() - 1;
  return (chain.bottomRows(bones) - chain.topRows(bones)).rowwise().norm();
}

/// Without joints that always coincide with the one before.
std::vector<Contour> without_points(const std::vector<Contour>& joints) {
  Eigen::VectorXd longest = Eigen::VectorXd::Zero(joints[0].rows() - 1);
  for (const Contour& chain : joints) longest = longest.cwiseMax(bone_lengths(chain));
  std::vector<Index> kept{0};
  for (Index i = 0; i < longest.size(); ++i) {
    if (longest[i] > 0) kept.push_back(i + 1);
  }
  if (kept.size() < 2) {
    throw std::invalid_argument("the length of a chain of joints is 0, but must be positive");
  }
  std::vector<Contour> result;
  for (const Contour& chain : joints) result.emplace_back(chain(kept, Eigen::all));
  return result;
}

/// One bone's share of the outline, on one side: an arc, a straight piece, an arc.
struct Piece {
  RowVector2d joint, along, normal;  ///< where the bone starts, unit vectors
  double begin = 0, end = 0;         ///< of the straight piece, from the joint on
  double before = 0, after = 0;      ///< angles of the arcs, signed as the normal turns
  double radius = 0;

  double length() const { return radius * (std::abs(before) + std::abs(after)) + end - begin; }

  RowVector2d point(double fraction) const {
    double left = fraction * length() - radius * std::abs(before);
    if (left < 0) return round(begin, std::copysign(-left / radius, -before));
    if (left <= end - begin) return round(begin + left, 0);
    left -= end - begin;
    return round(end, std::copysign(left / radius, after));
  }

  RowVector2d round(double place, double angle) const {
    const Eigen::Vector2d turned = Eigen::Rotation2Dd(angle) * normal.transpose();
    return joint + place * along + radius * turned.transpose();
  }
};

struct Bones {
  std::vector<RowVector2d> along;
  std::vector<double> length;
  std::vector<double> turn;  ///< at each joint, half of the angle; a quarter circle at the ends
};

Bones bones_of(const Contour& chain) {
  Bones bones;
  const Eigen::VectorXd lengths = bone_lengths(chain);
  bones.length.assign(lengths.begin(), lengths.end());
  const auto first = std::find_if(lengths.begin(), lengths.end(), [](double l) { return l > 0; });
  RowVector2d along(0, 1);
  for (Index i = 0; i < lengths.size(); ++i) {
    const Index measured = std::max<Index>(i, first - lengths.begin());
    if (measured < lengths.size() && lengths[measured] > 0) {
      along = (chain.row(measured + 1) - chain.row(measured)) / lengths[measured];
    }
    bones.along.push_back(along);
  }
  bones.turn.assign(static_cast<std::size_t>(chain.rows()), std::numbers::pi / 2);
  for (std::size_t i = 1; i < bones.along.size(); ++i) {
    const RowVector2d a = bones.along[i - 1], b = bones.along[i];
    bones.turn[i] = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) / 2;
  }
  return bones;
}

/// The pieces in the order of the outline: down on one side, up on the other; the latter are to be
/// run through from their end to their start.
std::vector<Piece> pieces_of(const Contour& chain, double radius) {
  const Bones bones = bones_of(chain);
  const std::size_t count = bones.along.size();
  std::vector<Piece> pieces;
  for (std::size_t n = 0; n < 2 * count; ++n) {
    const bool down = n < count;
    const std::size_t i = down ? n : 2 * count - 1 - n;
    const double side = down ? 1 : -1;
    Piece piece;
    piece.joint = chain.row(static_cast<Index>(i));
    piece.along = bones.along[i];
    piece.normal = side * RowVector2d(piece.along.y(), -piece.along.x());
    piece.radius = radius;
    // Inside of a bend there is no arc, and the straight piece is shorter.
    const auto arc = [&](std::size_t joint, double& straight_end, double direction) {
      const bool tip = joint == 0 || joint == count;
      const double half = bones.turn[joint];
      if (tip || side * half > 0) return side * std::abs(half);
      straight_end += direction * std::min(radius * std::tan(std::abs(half)), bones.length[i] / 2);
      return 0.0;
    };
    piece.end = bones.length[i];
    piece.before = arc(i, piece.begin, 1);
    piece.after = arc(i + 1, piece.end, -1);
    pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace

std::vector<Contour> skin_joints(const std::vector<Contour>& joints, double radius,
                                 Eigen::Index samples) {
  check_samples(samples);
  check(joints, radius);
  std::vector<std::vector<Piece>> frames;
  for (const Contour& chain : without_points(joints)) frames.push_back(pieces_of(chain, radius));
  const std::size_t count = frames[0].size();
  std::vector<double> ends(count, 0.0);
  for (std::size_t n = 0; n < count; ++n) {
    for (const auto& frame : frames) ends[n] += frame[n].length();
    if (n > 0) ends[n] += ends[n - 1];
  }
  std::vector<Contour> outlines(frames.size(), Contour(samples, 2));
  std::size_t n = 0;
  for (Index k = 0; k < samples; ++k) {
    const double place = ends.back() * static_cast<double>(k) / static_cast<double>(samples);
    while (place >= ends[n]) ++n;
    const double begin = n == 0 ? 0 : ends[n - 1];
    const double fraction = (place - begin) / (ends[n] - begin);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      outlines[i].row(k) = frames[i][n].point(n < count / 2 ? fraction : 1 - fraction);
    }
  }
  return outlines;
}

double chain_length(const std::vector<Contour>& joints) {
  double sum = 0;
  for (const Contour& chain : joints) sum += bone_lengths(chain).sum();
  return sum / static_cast<double>(joints.size());
}

}  // namespace wavecurve
