#include "wavecurve/transform/periodic_transform.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/bands.hpp"
#include "wavecurve/transform/plain_transform.hpp"

namespace wavecurve {
namespace {

template <class Scalar>
using Vector = Eigen::Vector<Scalar, Eigen::Dynamic>;

/// Taps and samples are drawn as small integers over 64, so that a failure prints readably.
template <class Scalar>
Vector<Scalar> any_vector(int size) {
  Vector<Scalar> x(size);
  for (Scalar& value : x) value = static_cast<Scalar>(*rc::gen::inRange(-64, 65)) / 64;
  return x;
}

template <class Scalar>
Filter<Scalar> any_filter() {
  const int size = *rc::gen::inRange(1, 21);
  const Vector<Scalar> taps = any_vector<Scalar>(size);
  return {*rc::gen::inRange(-15, 16), std::vector<Scalar>(taps.begin(), taps.end())};
}

/// Four unrelated filters: the transform must not lean on any relation between them.
template <class Scalar>
FilterBank<Scalar> any_bank() {
  FilterBank<Scalar> bank;
  bank.analysis_low = any_filter<Scalar>();
  bank.analysis_high = any_filter<Scalar>();
  bank.synthesis_low = any_filter<Scalar>();
  bank.synthesis_high = any_filter<Scalar>();
  return bank;
}

template <class Scalar>
double one_norm(const Filter<Scalar>& filter) {
  double sum = 0;
  for (Scalar tap : filter.taps) sum += std::abs(static_cast<double>(tap));
  return sum;
}

/// An output is reached through `levels` sums of products; each sum of up to 2 * 20 taps, and the
/// folding of the taps before it in the plain twin, errs by at most 2 * 40 roundings of the sum of
/// magnitudes, in each of the two programs, and the magnitudes grow by `gain` a level.
template <class Scalar>
double rounding_bound(int levels, double gain, double largest) {
  const double roundings = 2 * 2 * 40.0 * (levels + 1);
  return roundings * std::numeric_limits<Scalar>::epsilon() *
         std::pow(std::max(gain, 1.0), levels) * std::max(largest, 1e-30);
}

template <class Scalar>
void check_against_plain_twin() {
  const int levels = *rc::gen::inRange(0, 7);
  const int samples = *rc::gen::inRange(1, 15) << *rc::gen::inRange(levels, levels + 5);
  const FilterBank<Scalar> bank = any_bank<Scalar>();
  const PeriodicTransform<Scalar> transform(bank, samples, levels);
  const Vector<Scalar> x = any_vector<Scalar>(samples);
  Vector<Scalar> y(samples), workspace(transform.workspace_size());

  transform.forward(x, y, workspace);
  const double analysis_gain = std::max(one_norm(bank.analysis_low), one_norm(bank.analysis_high));
  RC_ASSERT((y - plain::forward_transform(bank, levels, x)).cwiseAbs().maxCoeff() <=
            rounding_bound<Scalar>(levels, analysis_gain, x.cwiseAbs().maxCoeff()));

  transform.inverse(x, y, workspace);
  const double synthesis_gain = one_norm(bank.synthesis_low) + one_norm(bank.synthesis_high);
  RC_ASSERT((y - plain::inverse_transform(bank, levels, x)).cwiseAbs().maxCoeff() <=
            rounding_bound<Scalar>(levels, synthesis_gain, x.cwiseAbs().maxCoeff()));
}

RC_GTEST_PROP(PeriodicTransform, EqualsThePlainTwinInDouble, ()) {
  check_against_plain_twin<double>();
}

RC_GTEST_PROP(PeriodicTransform, EqualsThePlainTwinInFloat, ()) {
  check_against_plain_twin<float>();
}

RC_GTEST_PROP(PeriodicTransform, AdjointsMoveToTheOtherSideOfTheInnerProduct, ()) {
  const int levels = *rc::gen::inRange(0, 5);
  const int samples = *rc::gen::inRange(1, 40) << levels;
  const FilterBank<double> bank = any_bank<double>();
  const PeriodicTransform<double> transform(bank, samples, levels);
  const Eigen::VectorXd x = any_vector<double>(samples), y = any_vector<double>(samples);
  Eigen::VectorXd ax(samples), ay(samples), workspace(transform.workspace_size());
  const double gain = one_norm(bank.analysis_low) + one_norm(bank.analysis_high) +
                      one_norm(bank.synthesis_low) + one_norm(bank.synthesis_high);
  const double tolerance = samples * rounding_bound<double>(levels, gain, 1);

  transform.forward(x, ax, workspace);
  transform.forward_adjoint(y, ay, workspace);
  RC_ASSERT(std::abs(ax.dot(y) - x.dot(ay)) <= tolerance);
  transform.inverse(x, ax, workspace);
  transform.inverse_adjoint(y, ay, workspace);
  RC_ASSERT(std::abs(ax.dot(y) - x.dot(ay)) <= tolerance);
}

/// Orthonormal: every level preserves the norm, so errors add up; 4 units of rounding a level and
/// direction. Biorthogonal: the condition of the transform comes on top, below 2 a level here.
RC_GTEST_PROP(PeriodicTransform, InverseUndoesForward, ()) {
  const char* name = *rc::gen::element("haar", "db4", "db10", "bspline4.4", "bspline2.4");
  const FilterBank<double> bank = find_filter_bank<double>(name);
  const int levels = *rc::gen::inRange(0, 9);
  const int samples = *rc::gen::inRange(1, 4) << levels;
  const PeriodicTransform<double> transform(bank, samples, levels);
  const Eigen::VectorXd x = any_vector<double>(samples);
  Eigen::VectorXd y(samples), z(samples), workspace(transform.workspace_size());
  transform.forward(x, y, workspace);
  transform.inverse(y, z, workspace);
  const double condition = bank.is_orthonormal() ? 1 : std::pow(2, levels);
  const double epsilon = std::numeric_limits<double>::epsilon();
  RC_ASSERT((z - x).norm() <= 4 * 2 * epsilon * (levels + 1) * condition * x.norm());
}

TEST(PeriodicTransform, HaarByHand) {
  const Filter<double> low{0, {1, 1}};  // not normalised, so that every value is exact
  const PeriodicTransform<double> transform(make_filter_bank<double>("sums", low, low), 4, 2);
  Eigen::Vector4d coefficients, samples(1, 2, 4, 8);
  Eigen::VectorXd workspace(transform.workspace_size());
  transform.forward(samples, coefficients, workspace);
  EXPECT_EQ(coefficients, Eigen::Vector4d(15, -9, -1, -4));
}

TEST(PlainTransform, FoldsTheFilterModuloThePeriod) {
  const Filter<double> filter{-1, {1, 2, 4, 8, 16}};
  EXPECT_EQ(plain::periodized(filter, 3), Eigen::Vector3d(2 + 16, 4, 1 + 8));
  EXPECT_EQ(plain::periodized(filter, 1), Eigen::VectorXd::Constant(1, 31));
}

TEST(Bands, CoverTheCoefficientsFromCoarseToFine) {
  const std::vector<Band> bands = multiscale_bands(24, 3);
  ASSERT_EQ(bands.size(), 4u);
  EXPECT_TRUE(bands[0].is_scaling);
  Eigen::Index next = 0;
  for (const Band& band : bands) {
    EXPECT_EQ(band.offset, next);
    EXPECT_EQ(band.size, 24 >> band.depth);
    next += band.size;
  }
  EXPECT_EQ(next, 24);
  EXPECT_EQ(band_borders(24, 3), (std::vector<Eigen::Index>{3, 6, 12}));
}

TEST(PeriodicTransform, RefusesWrongSizes) {
  const FilterBank<double> bank = find_filter_bank<double>("db4");
  EXPECT_THROW(PeriodicTransform<double>(bank, 0, 0), std::invalid_argument);
  EXPECT_THROW(PeriodicTransform<double>(bank, 12, 3), std::invalid_argument);
  EXPECT_THROW(PeriodicTransform<double>(bank, 12, -1), std::invalid_argument);
  const PeriodicTransform<double> transform(bank, 8, 2);
  Eigen::VectorXd eight(8), nine(9), workspace(transform.workspace_size());
  EXPECT_THROW(transform.forward(nine, eight, workspace), std::invalid_argument);
  EXPECT_THROW(transform.forward(eight, nine, workspace), std::invalid_argument);
  EXPECT_THROW(transform.forward(eight, eight, nine), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
