#include "wavecurve/transform/transform_batch.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve {
namespace {

template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

constexpr auto directions = {TransformDirection::forward, TransformDirection::inverse,
                             TransformDirection::forward_adjoint,
                             TransformDirection::inverse_adjoint};

/// Column counts around whole groups, with fewer and more threads than there is work.
template <class Scalar>
void expect_same_bits_on_any_number_of_threads() {
  const PeriodicTransform<Scalar> transform(find_filter_bank<Scalar>("coif2"), 64, 6);
  for (const Eigen::Index columns : {1, 7, 16, 33, 130}) {
    const Matrix<Scalar> input = Matrix<Scalar>::Random(64, columns);
    for (const TransformDirection direction : directions) {
      Matrix<Scalar> one(64, columns);
      transform_batch<Scalar>(transform, direction, input, one, 1);
      for (const int threads : {2, 3, 8, 100}) {
        Matrix<Scalar> many = Matrix<Scalar>::Zero(64, columns);
        transform_batch<Scalar>(transform, direction, input, many, threads);
        EXPECT_EQ(many, one) << columns << " columns on " << threads << " threads";
      }
    }
  }
}

TEST(TransformBatch, HasTheSameBitsOnAnyNumberOfThreads) {
  expect_same_bits_on_any_number_of_threads<double>();
  expect_same_bits_on_any_number_of_threads<float>();
}

TEST(TransformBatch, IsThePeriodicTransform) {
  const PeriodicTransform<double> transform(find_filter_bank<double>("db4"), 32, 5);
  const Matrix<double> input = Matrix<double>::Random(32, 20);
  Matrix<double> expected(32, 20), batch(32, 20);
  Eigen::VectorXd workspace(transform.workspace_size(20));
  transform.forward(input, expected, workspace);
  transform_batch<double>(transform, TransformDirection::forward, input, batch, 2);
  EXPECT_EQ(batch, expected);
  transform_batch<double>(transform, TransformDirection::inverse, batch, batch, 2);
  EXPECT_LT((batch - input).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(TransformBatch, RefusesBadSizesAndNumbersOfThreads) {
  const PeriodicTransform<double> transform(find_filter_bank<double>("db4"), 32, 5);
  const Matrix<double> input = Matrix<double>::Zero(32, 20),
                       short_input = Matrix<double>::Zero(16, 20);
  Matrix<double> output(32, 20), few(32, 4);
  const auto run = [&](const Matrix<double>& in, Matrix<double>& out, int threads) {
    transform_batch<double>(transform, TransformDirection::forward, in, out, threads);
  };
  EXPECT_THROW(run(input, output, 0), std::invalid_argument);
  EXPECT_THROW(run(short_input, output, 2), std::invalid_argument);
  EXPECT_THROW(run(input, few, 2), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
