#include "wavecurve/transform/detail/stockham_transform.hpp"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/elementary/detail/every_target_test.hpp"

namespace wavecurve {
namespace {

using Complex = StockhamTransform::Complex;

/// All lengths to 4096, both directions.
std::vector<Complex> transforms() {
  std::vector<Complex> results;
  for (Eigen::Index n = 1; n <= 4096; n *= 2) {
    std::vector<Complex> x(static_cast<std::size_t>(n));
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = {static_cast<double>(i * 37 % 64) / 7, static_cast<double>(i * 11 % 32) / 3};
    }
    StockhamTransform transform(n);
    for (const bool inverse : {false, true}) {
      transform.transform(x.data(), x.data(), inverse, 0.3);
      results.insert(results.end(), x.begin(), x.end());
    }
  }
  return results;
}

// That they are right is held by fourier_transform_test.cpp.
TEST(StockhamTransform, GivesTheSameBitsOnEveryTarget) {
  expect_the_same_bits_on_every_target(transforms);
}

TEST(StockhamTransform, RefusesOtherLengths) {
  for (const Eigen::Index n : {-1, 0, 3, 100}) {
    EXPECT_THROW(StockhamTransform{n}, std::invalid_argument) << n;
  }
}

}  // namespace
}  // namespace wavecurve
