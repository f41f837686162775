// Many signals at once: whatever the number of columns, the strides and the place of the output, a
// column's result is, to the last bit, that of the column alone.
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve {
namespace {

template <class Scalar>
using Transform = PeriodicTransform<Scalar>;
template <class Scalar>
using Matrix = typename Transform<Scalar>::Matrix;
template <class Scalar>
using Vector = Eigen::Vector<Scalar, Eigen::Dynamic>;

enum class Direction { forward, inverse, forward_adjoint, inverse_adjoint };

template <class Scalar>
void run(const Transform<Scalar>& transform, Direction direction, typename Transform<Scalar>::In in,
         typename Transform<Scalar>::Out out) {
  Vector<Scalar> workspace(transform.workspace_size(in.cols()));
  switch (direction) {
    case Direction::forward:
      return transform.forward(in, out, workspace);
    case Direction::inverse:
      return transform.inverse(in, out, workspace);
    case Direction::forward_adjoint:
      return transform.forward_adjoint(in, out, workspace);
    case Direction::inverse_adjoint:
      return transform.inverse_adjoint(in, out, workspace);
  }
}

template <class Scalar>
Matrix<Scalar> any_matrix(Eigen::Index rows, Eigen::Index columns) {
  Matrix<Scalar> x(rows, columns);
  for (Scalar& value : x.reshaped()) value = static_cast<Scalar>(*rc::gen::inRange(-64, 65)) / 64;
  return x;
}

/// Columns of a matrix in memory of their own, with room between the values and the columns.
template <class Scalar>
class Strided {
 public:
  Strided(const Matrix<Scalar>& x, bool row_major)
      : inner_(*rc::gen::inRange(1, 4)), outer_(inner_ * x.rows() + *rc::gen::inRange(0, 5)) {
    if (row_major) {
      outer_ = inner_;
      inner_ = outer_ * x.cols() + *rc::gen::inRange(0, 5);
    }
    memory_.setConstant(x.rows() * inner_ + x.cols() * outer_ + 1, Scalar(7));
    view(x.rows(), x.cols()) = x;
  }
  Eigen::Map<Matrix<Scalar>, 0, typename Transform<Scalar>::Strides> view(Eigen::Index rows,
                                                                          Eigen::Index columns) {
    return {memory_.data(), rows, columns, {outer_, inner_}};
  }
  /// What lies between the values, as it was.
  bool gaps_are_whole(Eigen::Index rows, Eigen::Index columns) {
    view(rows, columns).setConstant(Scalar(7));
    return (memory_.array() == Scalar(7)).all();
  }

 private:
  Eigen::Index inner_, outer_;
  Vector<Scalar> memory_;
};

template <class Scalar>
void check_columns() {
  const char* name = *rc::gen::element("haar", "db4", "db10", "coif5", "bspline4.4", "cdf9.7");
  const auto direction = *rc::gen::element(Direction::forward, Direction::inverse,
                                           Direction::forward_adjoint, Direction::inverse_adjoint);
  const int levels = *rc::gen::inRange(0, 6);
  const Eigen::Index samples = *rc::gen::inRange(1, 20) << levels;
  const Eigen::Index columns = *rc::gen::inRange(0, 40);
  const Transform<Scalar> transform(find_filter_bank<Scalar>(name), samples, levels);
  const Matrix<Scalar> x = any_matrix<Scalar>(samples, columns);
  Matrix<Scalar> expected(samples, columns), y(samples, columns);
  for (Eigen::Index j = 0; j < columns; ++j) run(transform, direction, x.col(j), expected.col(j));

  run(transform, direction, x, y);
  RC_ASSERT(y == expected);
  y = x;
  run(transform, direction, y, y);
  RC_ASSERT(y == expected);

  Strided<Scalar> in(x, *rc::gen::arbitrary<bool>()), out(x, *rc::gen::arbitrary<bool>());
  run(transform, direction, in.view(samples, columns), out.view(samples, columns));
  RC_ASSERT(in.view(samples, columns) == x);
  RC_ASSERT(out.view(samples, columns) == expected);
  run(transform, direction, in.view(samples, columns), in.view(samples, columns));
  RC_ASSERT(in.view(samples, columns) == expected);
  RC_ASSERT(in.gaps_are_whole(samples, columns));
  RC_ASSERT(out.gaps_are_whole(samples, columns));
}

RC_GTEST_PROP(PeriodicTransformColumns, AreTransformedEachAloneInDouble, ()) {
  check_columns<double>();
}
RC_GTEST_PROP(PeriodicTransformColumns, AreTransformedEachAloneInFloat, ()) {
  check_columns<float>();
}

TEST(PeriodicTransformColumns, MayBeLong) {
  for (int samples : {2048, 4096, 3 * 4096}) {
    const Transform<double> transform(find_filter_bank("db4"), samples, 10);
    Eigen::MatrixXd x = Eigen::MatrixXd::Random(samples, 11), expected = x;
    for (Eigen::Index j = 0; j < x.cols(); ++j) {
      run(transform, Direction::forward, x.col(j), expected.col(j));
    }
    run(transform, Direction::forward, x, x);
    EXPECT_EQ(x, expected);
  }
}

/// Long signals are taken several levels at a time; in place, and level by level, they are not.
template <class Scalar>
void expect_fused_levels_to_give_the_same_bits() {
  for (const char* name : {"haar", "db4", "db38", "bspline4.4"}) {
    const FilterBank<Scalar> bank = find_filter_bank<Scalar>(name);
    for (Eigen::Index samples : {1 << 21, 5 << 19}) {
      for (int levels : {3, 5}) {
        const Transform<Scalar> transform(bank, samples, levels);
        const Vector<Scalar> x = Vector<Scalar>::Random(samples);
        Vector<Scalar> y(samples), in_place = x, one_by_one = x;
        run(transform, Direction::forward, x, y);
        run(transform, Direction::forward, in_place, in_place);
        EXPECT_TRUE(in_place == y) << name << ", forward, " << levels << " levels";
        for (int level = 0; level < levels; ++level) {
          const Transform<Scalar> one_level(bank, samples >> level, 1);
          auto part = one_by_one.head(samples >> level);
          run(one_level, Direction::forward, part, part);
        }
        EXPECT_TRUE(one_by_one == y) << name << ", forward, " << levels << " levels";

        run(transform, Direction::inverse, x, y);
        in_place = one_by_one = x;
        run(transform, Direction::inverse, in_place, in_place);
        EXPECT_TRUE(in_place == y) << name << ", inverse, " << levels << " levels";
        for (int level = levels - 1; level >= 0; --level) {
          const Transform<Scalar> one_level(bank, samples >> level, 1);
          auto part = one_by_one.head(samples >> level);
          run(one_level, Direction::inverse, part, part);
        }
        EXPECT_TRUE(one_by_one == y) << name << ", inverse, " << levels << " levels";
      }
    }
  }
}

TEST(PeriodicTransformColumns, EqualTheLevelsOneByOneForLongSignalsInDouble) {
  expect_fused_levels_to_give_the_same_bits<double>();
}
TEST(PeriodicTransformColumns, EqualTheLevelsOneByOneForLongSignalsInFloat) {
  expect_fused_levels_to_give_the_same_bits<float>();
}

TEST(PeriodicTransformColumns, AreNotCopiedToBeSeen) {
  const auto sees = [](Transform<double>::In x) { return x.data(); };
  Eigen::MatrixXd x(8, 6);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(8, 6);
  Eigen::Matrix<double, Eigen::Dynamic, 2> contour(8, 2);
  EXPECT_EQ(sees(x), x.data());
  EXPECT_EQ(sees(contour), contour.data());
  EXPECT_EQ(sees(x.col(1)), &x(0, 1));
  EXPECT_EQ(sees(x.row(1).transpose()), &x(1, 0));
  EXPECT_EQ(sees(x.block(2, 1, 4, 3)), &x(2, 1));
  EXPECT_EQ(sees(rows.col(1)), &rows(0, 1));
  const Eigen::Ref<const Eigen::VectorXd> part = x.col(2).segment(1, 4);
  EXPECT_EQ(sees(part), &x(1, 2));
}

TEST(PeriodicTransformColumns, AreRefusedInWrongNumbers) {
  const Transform<double> transform(find_filter_bank("db4"), 8, 2);
  Eigen::MatrixXd x(8, 5), y(8, 4), z(9, 5), u(8, 5);
  Eigen::VectorXd workspace(transform.workspace_size(5)), small(transform.workspace_size(5) - 1);
  EXPECT_THROW(transform.forward(x, y, workspace), std::invalid_argument);
  EXPECT_THROW(transform.forward(x, z, workspace), std::invalid_argument);
  EXPECT_THROW(transform.forward(x, u, small), std::invalid_argument);
  EXPECT_NO_THROW(transform.forward(x.setZero(), u, workspace));
}

}  // namespace
}  // namespace wavecurve
