// How well distances of shapes find an outline again that was altered: those by wavelets, and the yardstick, elliptic
// Fourier descriptors. The set is that of docs/measured.md.
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "wavecurve/curves/normalized_contour.hpp"
#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/curves/shape_distance.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"
#include "wavecurve/io/tracks/read_limb_tracks.hpp"

namespace wavecurve::io {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;

const fs::path shared = fs::path(WAVECURVE_SOURCE_DIR) / "../shared/data";
constexpr Index samples = 256;
/// docs/measured.md has the counts for five queries a shape, which take longer.
constexpr int levels = 5, queries_a_shape = 1;

using Random = std::mt19937_64;

double between(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Six silhouettes of animals, and the frames of a galloping horse, which resemble each other.
std::vector<Contour> outlines() {
  std::vector<Contour> result;
  for (const char* name : {"bird-1", "camel-1", "dog-1", "elephant-1", "fish-1", "horse-1"}) {
    const auto path = shared / "silhouettes" / (std::string(name) + ".svg");
    result.push_back(sample_layer(read_drawing(path).drawing.layers.at(0), 1024).at(0));
  }
  const auto tracks =
      read_limb_tracks({shared / "animal_frames/muybridge_horse.csv"}, {.limbs = {"0"}});
  for (const Contour& outline : tracks.limbs.at(0).outlines) result.push_back(outline);
  return result;
}

/// Turned, scaled, moved, from another start, and every other time the other way round.
Contour placed(const Contour& points, Random& random) {
  const double angle = between(random, 0, 2 * std::numbers::pi), size = between(random, 0.2, 5);
  const Eigen::Matrix2d turn = size * Eigen::Rotation2Dd(angle).toRotationMatrix();
  Contour result = points * turn.transpose();
  const auto start = static_cast<Index>(between(random, 0, static_cast<double>(points.rows())));
  Contour started(points.rows(), 2);
  started << result.bottomRows(points.rows() - start), result.topRows(start);
  if (random() % 2 == 0) started = started.colwise().reverse().eval();
  return started.rowwise() + Eigen::RowVector2d(between(random, -9, 9), between(random, -9, 9));
}

Contour noisy(const Contour& points, Random& random) {
  const double amplitude = 0.05 * contour_size(points);
  Contour result = points;
  for (double& value : result.reshaped()) value += between(random, -amplitude, amplitude);
  return result;
}

Contour stretched(const Contour& points, Random& random) {
  const auto turn = Eigen::Rotation2Dd(between(random, 0, std::numbers::pi)).toRotationMatrix();
  const Eigen::Matrix2d stretch = turn * Eigen::Vector2d(1.25, 1).asDiagonal() * turn.transpose();
  return points * stretch.transpose();
}

/// Every 32nd point or so.
Contour thinned(const Contour& points, Random& random) {
  std::vector<Index> kept;
  for (Index i = 0; i < points.rows(); ++i) {
    if (random() % 32 == 0) kept.push_back(i);
  }
  return points(kept, Eigen::all);
}

struct Rates {
  int wavelets = 0, fourier = 0, all = 0;
};

Rates retrieve(const std::vector<Contour>& shapes,
               const std::function<Contour(const Contour&, Random&)>& alter) {
  Random random(2024);
  const FilterBank<double> bank = find_filter_bank("coif2");
  std::vector<Contour> known;
  for (const Contour& shape : shapes) known.push_back(sample_contour(shape, samples));
  Rates rates;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (int k = 0; k < queries_a_shape; ++k) {
      const Contour query = sample_contour(placed(alter(shapes[i], random), random), samples);
      std::size_t by_wavelets = 0, by_fourier = 0;
      double nearest = std::numeric_limits<double>::infinity(), nearest_fourier = nearest;
      for (std::size_t other = 0; other < known.size(); ++other) {
        const double distance = shape_distance(query, known[other], bank, levels).total;
        const double fourier = elliptic_fourier_distance(query, known[other]);
        if (distance < nearest) nearest = distance, by_wavelets = other;
        if (fourier < nearest_fourier) nearest_fourier = fourier, by_fourier = other;
      }
      rates.wavelets += by_wavelets == i;
      rates.fourier += by_fourier == i;
      ++rates.all;
    }
  }
  return rates;
}

TEST(ShapeRetrieval, AlteredOutlinesAreFoundAgain) {
  if (!fs::exists(shared)) GTEST_SKIP() << "no " << shared;
  const auto same = [](const Contour& points, Random&) { return points; };
  const std::pair<const char*, std::function<Contour(const Contour&, Random&)>> alterations[] = {
      {"placed", same}, {"noisy", noisy}, {"stretched", stretched}, {"thinned", thinned}};
  const std::vector<Contour> shapes = outlines();
  Rates sum;
  for (const auto& [name, alter] : alterations) {
    const Rates rates = retrieve(shapes, alter);
    std::printf("%s: %d by wavelets, %d by elliptic Fourier descriptors, of %d\n", name,
                rates.wavelets, rates.fourier, rates.all);
    if (std::string(name) == "placed") {
      EXPECT_EQ(rates.wavelets, rates.all);
    }
    sum.wavelets += rates.wavelets, sum.fourier += rates.fourier, sum.all += rates.all;
  }
  EXPECT_GE(sum.wavelets, sum.fourier);
}

}  // namespace
}  // namespace wavecurve::io
