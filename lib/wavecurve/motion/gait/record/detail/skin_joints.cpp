#include "wavecurve/motion/gait/record/detail/skin_joints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::gait {

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
  check_above_zero("the radius of a limb", radius);
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
    throw std::invalid_argument(must_be("the length of a chain of joints", 0, "above 0"));
  }
  std::vector<Contour> result;
  for (const Contour& chain : joints) result.emplace_back(chain(kept, Eigen::all));
  return result;
}

/// A part of the outline that belongs to one side of a bone: a line along it, or half of the arc
/// about one of its joints.
struct Piece {
  RowVector2d joint, along, normal;  ///< where the bone starts, unit vectors
  double length = 0, radius = 0;     ///< of the bone
  double begin = 0, end = 0;         ///< of what is not inside of a bend, from the joint on
  double place = 0;                  ///< of the centre of an arc
  double from = 0, to = 0;           ///< angles of an arc, as its normal turns; of a line, none
  bool arc = false;

  double extent() const { return arc ? radius * std::abs(to - from) : length; }

  /// Inside of a bend, the points of the arc wait in the corner.
  RowVector2d point(double fraction) const {
    const double centre = arc ? std::clamp(place, begin, end) : begin + fraction * (end - begin);
    const Eigen::Rotation2Dd turn(from + fraction * (to - from));
    const Eigen::Vector2d turned = turn * normal.transpose();
    return joint + centre * along + radius * turned.transpose();
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
    bones.turn[i] = arctangent(a.x() * b.y() - a.y() * b.x(), a.dot(b)) / 2;
  }
  return bones;
}

/// An arc, a line, an arc, from one joint of a bone to the next; side: 1 or -1.
std::array<Piece, 3> pieces_of(const Contour& chain, const Bones& bones, std::size_t bone,
                               double side, double radius) {
  Piece line;
  line.joint = chain.row(static_cast<Index>(bone));
  line.along = bones.along[bone];
  line.normal = side * RowVector2d(line.along.y(), -line.along.x());
  line.length = line.end = bones.length[bone];
  line.radius = radius;
  Piece before = line, after = line;
  before.arc = after.arc = true;
  after.place = line.length;
  const auto bend = [&](std::size_t joint) -> double {
    const bool tip = joint == 0 || joint == bones.along.size();
    return tip ? bones.turn[joint] : side * bones.turn[joint];
  };
  const double first = bend(bone), last = bend(bone + 1);
  // Outside of a bend there is an arc; inside the line is shorter.
  const auto corner = [&](double angle) {
    return std::min(radius * tangent(std::abs(angle)), line.length / 2);
  };
  if (first > 0)
    before.from = -side * first;
  else
    line.begin = corner(first);
  if (last > 0)
    after.to = side * last;
  else
    line.end = line.length - corner(last);
  for (Piece* piece : {&before, &after}) piece->begin = line.begin, piece->end = line.end;
  return {before, line, after};
}

/// The pieces in the order of the outline: down on one side, up on the other; the latter are to be
/// run through from their end to their start.
std::vector<Piece> outline_of(const Contour& chain, double radius) {
  const Bones bones = bones_of(chain);
  const std::size_t count = bones.along.size();
  std::vector<Piece> pieces;
  for (std::size_t bone = 0; bone < count; ++bone) {
    for (const Piece& piece : pieces_of(chain, bones, bone, 1, radius)) pieces.push_back(piece);
  }
  for (std::size_t bone = count; bone-- > 0;) {
    const auto three = pieces_of(chain, bones, bone, -1, radius);
    pieces.insert(pieces.end(), three.rbegin(), three.rend());
  }
  return pieces;
}

}  // namespace

std::vector<Contour> skin_joints(const std::vector<Contour>& joints, double radius,
                                 Eigen::Index samples) {
  check_samples(samples);
  check(joints, radius);
  std::vector<std::vector<Piece>> frames;
  for (const Contour& chain : without_points(joints)) {
    frames.push_back(outline_of(chain, radius));
  }
  const std::size_t count = frames[0].size();
  std::vector<double> ends(count, 0.0);
  for (std::size_t n = 0; n < count; ++n) {
    for (const auto& frame : frames) ends[n] += frame[n].extent();
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

}  // namespace wavecurve::gait
