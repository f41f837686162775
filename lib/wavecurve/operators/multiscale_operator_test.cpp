#include "wavecurve/operators/multiscale_operator.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

namespace wavecurve {
namespace {

// Sizes beyond the blocks of the kernels; small ones are in multiscale_matrix_test.cpp.
TEST(MultiscaleOperator, AppliesTheAssembledMatrix) {
  for (const char* name : {"db4", "bspline4.4"}) {
    const FilterBank<double> bank = find_filter_bank<double>(name);
    for (int levels : {0, 2, 14}) {
      const int samples = 1 << 14;
      const auto matrix = stiffness(bank, samples, levels);
      MultiscaleOperator matrix_free(bank, samples, levels);
      Eigen::VectorXd x(samples), y(samples);
      for (int i = 0; i < samples; ++i) x[i] = (i * 37 % 101) / 50.0 - 1;
      matrix_free.apply(x, y);
      // The norm of K is about its Frobenius norm over sqrt(samples); some hundred roundings of it.
      const double scale = matrix.norm() / std::sqrt(samples) * x.norm();
      EXPECT_LE((matrix * x - y).norm(), 256 * std::numeric_limits<double>::epsilon() * scale);
    }
  }
}

TEST(MultiscaleOperator, RefusesWrongSizes) {
  MultiscaleOperator matrix(find_filter_bank<double>("db4"), 8, 2);
  Eigen::VectorXd eight(8), nine(9);
  EXPECT_THROW(matrix.apply(nine, eight), std::invalid_argument);
  EXPECT_THROW(matrix.apply(eight, nine), std::invalid_argument);
  EXPECT_THROW(MultiscaleOperator(find_filter_bank<double>("db4"), 12, 2), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
