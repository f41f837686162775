#include <cmath>
#include <numbers>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/crossings.hpp"
#include "wavecurve/curves/fit_cubics.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/motion/morph/contour_morph.hpp"

#include "benchmarks/kernels/kernel.hpp"

namespace wavecurve::tracking {

namespace {

/// A wavy ring, its waves and start depending on `leaves`.
Contour rosette(Eigen::Index points, int leaves) {
  Contour contour(points, 2);
  for (Eigen::Index i = 0; i < points; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    const double radius = 3 + std::cos(leaves * t) + 0.3 * std::sin(t + leaves);
    contour.row(i) << radius * std::cos(t), radius * std::sin(t);
  }
  return contour;
}

std::function<void()> frame(Eigen::Index points) {
  const motion::ContourPair pair{rosette(points, 5), rosette(points, 12)};
  return [pair, morph = motion::ContourMorph(find_filter_bank("bspline4.4"), points, 8, points),
          shape = pair.source]() mutable {
    morph.frame(pair, 0.3, motion::detail_shares(motion::Detail::blend, 0.25, 0.3), shape);
  };
}

using Shift = Eigen::Index (*)(const Eigen::Ref<const Contour>&, const Eigen::Ref<const Contour>&,
                               Rotation);

std::function<void()> correspondence(Shift shift, Eigen::Index points) {
  return [shift, from = rosette(points, 5), to = rosette(points, 12)] {
    shift(from, to, Rotation::taken_out);
  };
}

std::function<void()> crossings(Eigen::Index points) {
  return [contour = rosette(points, 12)] { count_crossings(contour); };
}

std::function<void()> plain_crossings(Eigen::Index points) {
  return [contour = rosette(points, 12)] { plain::count_crossings(contour); };
}

std::function<void()> cubics(Eigen::Index points) {
  return [keys = std::vector{rosette(points, 5), rosette(points, 12)}] { fit_cubics(keys, 1e-3); };
}

Kernel growing(std::string name, Eigen::Index size,
               std::function<std::function<void()>(Eigen::Index)> prepare,
               std::vector<Eigen::Index> sizes) {
  Kernel kernel{std::move(name), size, std::move(prepare)};
  kernel.growth = Kernel::Growth::linearithmic;
  kernel.sizes = std::move(sizes);
  return kernel;
}

}  // namespace

std::vector<Kernel> curve_kernels() {
  const std::vector<Eigen::Index> sizes{256, 1024, 4096, 16384};
  Kernel shift = growing(
      "correspondence", 1024, [](Eigen::Index n) { return correspondence(best_shift, n); }, sizes);
  // Two complex transforms there and one back of 5 N log2 N each, and a product each point.
  shift.operations = 3 * 5.0 * 1024 * 10 + 6.0 * 1024;
  shift.bytes = 2 * 2 * 8 * 1024;
  Kernel cross = growing("crossings", 1024, crossings, sizes);
  cross.bytes = 2 * 8 * 1024;
  // 2 N boxes of 4 comparisons; where two halves join, two tests of 4 at each of the 2 l levels
  // below them, in all 32 N; and the orientation of an end, 7, each pair of neighbours.
  cross.operations = (8 + 32 + 7) * 1024;
  Kernel morph{"linear_frame", 1024, frame};
  morph.bytes = 3 * 2 * 8 * 1024;
  // A point of a column: 2 products and a sum of the blend, and of all levels two sums of 8
  // products, those of the 5 and 11 taps of the spline's synthesis by halves.
  morph.operations = 2 * (3 + 2 * 15.0) * 1024;
  return {shift, cross, morph, {"fit_cubics", 256, cubics}};
}

std::vector<Kernel> plain_kernels() {
  const std::vector<Eigen::Index> sizes{64, 128, 256, 512};
  return {growing(
              "plain_correspondence", 256,
              [](Eigen::Index n) { return correspondence(plain::best_shift, n); }, sizes),
          growing("plain_crossings", 256, plain_crossings, sizes)};
}

}  // namespace wavecurve::tracking
