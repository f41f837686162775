#include "wavecurve/transform/synthesis_matrix.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/plain_transform.hpp"

namespace wavecurve {
namespace {

TEST(SynthesisMatrix, HasTheInverseTransformsOfUnitVectorsAsColumns) {
  for (const char* name : {"haar", "db4", "bspline4.4"}) {
    const FilterBank<double> bank = find_filter_bank<double>(name);
    for (int samples : {1, 2, 12, 64}) {
      for (int levels = 0; samples % (1 << levels) == 0; ++levels) {
        const Eigen::MatrixXd matrix = synthesis_matrix(bank, samples, levels);
        for (int j = 0; j < samples; ++j) {
          const Eigen::VectorXd column =
              plain::inverse_transform(bank, levels, Eigen::VectorXd::Unit(samples, j));
          // Levels of sums of at most 40 products of numbers below 2.
          const double tolerance = 80 * (levels + 1) * std::numeric_limits<double>::epsilon();
          EXPECT_LE((matrix.col(j) - column).cwiseAbs().maxCoeff(), tolerance);
        }
      }
    }
  }
}

TEST(SynthesisMatrix, IsOrthogonalForAnOrthonormalBankAndStoresNoZeros) {
  const Eigen::SparseMatrix<double> s = synthesis_matrix(find_filter_bank<double>("db4"), 256, 5);
  const Eigen::MatrixXd product = s.transpose() * s;
  // Columns of norm 1 that err by a few roundings a level, six levels.
  const double tolerance = 8 * 6 * std::numeric_limits<double>::epsilon();
  EXPECT_LE((product - Eigen::MatrixXd::Identity(256, 256)).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_TRUE(s.isCompressed());
  // A column of depth m has 7 (2^m - 1) + 1 entries.
  EXPECT_EQ(s.nonZeros(), 128 * 8 + 64 * 22 + 32 * 50 + 16 * 106 + (8 + 8) * 218);
  EXPECT_EQ(s.nonZeros(), (s.toDense().array() != 0).count());
}

}  // namespace
}  // namespace wavecurve
