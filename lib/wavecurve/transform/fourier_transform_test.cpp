#include "wavecurve/transform/fourier_transform.hpp"

#include <cmath>
#include <limits>
#include <unsupported/Eigen/FFT>
#include <vector>

#include <gtest/gtest.h>

namespace wavecurve {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST(FourierTransform, IsTheSumForShortLengths) {
  for (const Eigen::Index n : {1, 2, 4, 8, 64}) {
    Eigen::VectorXcd x = Eigen::VectorXcd::Random(n), expected = Eigen::VectorXcd::Zero(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      for (Eigen::Index j = 0; j < n; ++j) {
        expected[k] += x[j] * std::polar(1.0, -2 * M_PI * double(j * k % n) / double(n));
      }
    }
    FourierTransform(n).forward(x);
    EXPECT_LT((x - expected).norm(), 64 * epsilon * expected.norm()) << n;
  }
}

// Eigen's is the plain twin: of all powers of two that are transformed directly, of two in four
// steps, and of other lengths, among them primes.
TEST(FourierTransform, IsEigensForwardsAndBack) {
  std::vector<Eigen::Index> sizes{3, 5, 100, 127, 1000};
  for (Eigen::Index n = 2; n <= 1 << 16; n *= 2) sizes.push_back(n);
  for (const Eigen::Index n : sizes) {
    const Eigen::VectorXcd x = Eigen::VectorXcd::Random(n);
    Eigen::VectorXcd expected(n), y = x;
    Eigen::FFT<double>().fwd(expected, x);
    FourierTransform transform(n);
    transform.forward(y);
    EXPECT_LT((y - expected).norm(), 8 * epsilon * expected.norm()) << n;
    transform.inverse(y);
    EXPECT_LT((y - x).norm(), 8 * epsilon * x.norm()) << n;
  }
}

}  // namespace
}  // namespace wavecurve
