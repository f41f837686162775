#include "wavecurve/operators/detail/circulant_product.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/elementary/detail/every_target_test.hpp"

namespace wavecurve {
namespace {

std::vector<double> numbers(std::size_t count, int step) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = static_cast<double>((static_cast<int>(i) * step + 11) % 64 - 31) / 7;
  }
  return values;
}

/// Tries each number of weights up to 12, those that are unrolled among them, and counts that are
/// whole vectors and that are not.
template <class Use>
void for_each_case(Use use) {
  for (std::size_t weights = 1; weights <= 12; ++weights) {
    for (const Eigen::Index count : {1, 3, 4, 16, 17, 70}) {
      for (const int sign : {1, -1}) {
        const auto size = static_cast<std::size_t>(count) + 2 * (weights - 1);
        use(numbers(weights, 13), sign, numbers(size, 37), count);
      }
    }
  }
}

std::vector<double> product(const std::vector<double>& weights, int sign,
                            const std::vector<double>& x, Eigen::Index count) {
  std::vector<double> out(static_cast<std::size_t>(count) + 1, 1996);
  circulant_product(weights, sign, x.data() + weights.size() - 1, count, out.data());
  return out;
}

TEST(CirculantProduct, IsTheSumAndWritesNoMore) {
  for_each_case([](const auto& weights, int sign, const auto& x, Eigen::Index count) {
    const std::vector<double> out = product(weights, sign, x, count);
    const std::size_t reach = weights.size() - 1;
    for (std::size_t i = 0; i + 1 < out.size(); ++i) {
      double sum = weights[0] * x[i + reach], magnitude = std::abs(sum);
      for (std::size_t l = 1; l <= reach; ++l) {
        const double before = x[i + reach - l], after = x[i + reach + l];
        sum += weights[l] * before + sign * weights[l] * after;
        magnitude += std::abs(weights[l]) * (std::abs(before) + std::abs(after));
      }
      // Each term takes at most three roundings and one a sum, here and there.
      const double unit = std::numeric_limits<double>::epsilon() / 2;
      const double bound = 2 * static_cast<double>(weights.size() + 3) * unit * magnitude;
      EXPECT_NEAR(out[i], sum, bound) << weights.size() << " weights, " << count << ", " << sign;
    }
    EXPECT_EQ(out.back(), 1996);
  });
}

TEST(CirculantProduct, GivesTheSameBitsOnEveryTarget) {
  expect_the_same_bits_on_every_target([] {
    std::vector<double> all;
    for_each_case([&](const auto& weights, int sign, const auto& x, Eigen::Index count) {
      const std::vector<double> out = product(weights, sign, x, count);
      all.insert(all.end(), out.begin(), out.end());
    });
    return all;
  });
}

}  // namespace
}  // namespace wavecurve
