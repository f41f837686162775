#include "wavecurve/transform/detail/rotation_kernels.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "wavecurve/elementary/detail/every_target_test.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/periodic_transform.hpp"
#include "wavecurve/transform/plain_transform.hpp"

namespace wavecurve {
namespace {

const char* const families[] = {"haar",  "db2",   "db4",   "db5",   "db10",       "db38",  "sym4",
                                "sym20", "coif1", "coif2", "coif5", "bspline4.4", "cdf9.7"};

template <class Scalar>
using Vector = Eigen::Vector<Scalar, Eigen::Dynamic>;

/// Forward and inverse of every length and all its levels, of one signal and of a group of them,
/// one behind the other.
template <class Scalar>
std::vector<Scalar> transforms(const FilterBank<Scalar>& bank) {
  std::vector<Scalar> results;
  for (int samples : {1, 2, 6, 8, 20, 64, 72, 202, 512}) {
    for (int levels = 0; samples % (1 << levels) == 0; ++levels) {
      const PeriodicTransform<Scalar> transform(bank, samples, levels);
      for (int columns : {1, 5}) {
        Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> x(samples, columns);
        Vector<Scalar> workspace(transform.workspace_size(columns));
        for (int i = 0; i < x.size(); ++i) {
          x.data()[i] = static_cast<Scalar>((i * 37 + 11) % 64 - 31) / 8;
        }
        transform.forward(x, x, workspace);
        results.insert(results.end(), x.data(), x.data() + x.size());
        transform.inverse(x, x, workspace);
        results.insert(results.end(), x.data(), x.data() + x.size());
      }
    }
  }
  return results;
}

template <class Scalar>
void expect_the_same_transforms() {
  for (const char* name : families) {
    SCOPED_TRACE(name);
    const FilterBank<Scalar> bank = find_filter_bank<Scalar>(name);
    expect_the_same_bits_on_every_target([&] { return transforms(bank); });
  }
}

TEST(RotationKernels, GiveTheSameBitsOnEveryTargetInDouble) {
  expect_the_same_transforms<double>();
}

TEST(RotationKernels, GiveTheSameBitsOnEveryTargetInFloat) { expect_the_same_transforms<float>(); }

/// A level of a cascade is orthogonal up to the rounding of its tangents and scale. It errs by the
/// taps' error, at most K units (see rotation_cascade.cpp), and by three roundings a rotation; the
/// twin by its 4 K additions and multiplications. Norms of errors add up over the levels.
template <class Scalar>
void expect_the_plain_twins_values() {
  int with_cascade = 0;
  for (const char* name : families) {
    const FilterBank<Scalar> bank = find_filter_bank<Scalar>(name);
    if (!bank.is_orthonormal()) continue;
    const auto cascade = rotation_cascade(bank.analysis_low, bank.analysis_high);
    if (!cascade) continue;
    ++with_cascade;
    for (int samples : {1, 2, 12, 72, 256}) {
      for (int levels = 0; samples % (1 << levels) == 0; ++levels) {
        const PeriodicTransform<Scalar> transform(bank, samples, levels);
        Vector<Scalar> x = Vector<Scalar>::LinSpaced(samples, -1, 3), y(samples);
        Vector<Scalar> workspace(transform.workspace_size());
        const double tolerance = 8 * cascade->size() * levels * x.norm() *
                                 static_cast<double>(std::numeric_limits<Scalar>::epsilon());
        transform.forward(x, y, workspace);
        EXPECT_LE((y - plain::forward_transform(bank, levels, x)).norm(), tolerance)
            << name << " " << samples << " " << levels;
        transform.inverse(x, y, workspace);
        EXPECT_LE((y - plain::inverse_transform(bank, levels, x)).norm(), tolerance)
            << name << " " << samples << " " << levels;
      }
    }
  }
  EXPECT_GE(with_cascade, 10);
}

TEST(RotationKernels, EqualThePlainTwinInDouble) { expect_the_plain_twins_values<double>(); }
TEST(RotationKernels, EqualThePlainTwinInFloat) { expect_the_plain_twins_values<float>(); }

TEST(RotationCascade, IsRefusedWhereThePairIsNotOrthonormal) {
  const FilterBank<double> spline = find_filter_bank<double>("bspline4.4");
  EXPECT_FALSE(rotation_cascade(spline.analysis_low, spline.analysis_high));
  FilterBank<double> d8 = find_filter_bank<double>("db4");
  EXPECT_TRUE(rotation_cascade(d8.analysis_low, d8.analysis_high));
  d8.analysis_low.taps[3] += 1e-13;
  EXPECT_FALSE(rotation_cascade(d8.analysis_low, d8.analysis_high));
}

TEST(RotationCascade, IsRefusedForMoreTapsThanTheKernelsHold) {
  // Haar's filter with zeros behind it: orthonormal at every length.
  for (int taps : {128, 130}) {
    Filter<double> low{0, std::vector<double>(static_cast<std::size_t>(taps), 0.0)};
    low.taps[0] = low.taps[1] = std::sqrt(0.5);
    EXPECT_EQ(rotation_cascade(low, conjugate_mirror(low)).has_value(), taps == 128);
  }
}

}  // namespace
}  // namespace wavecurve
