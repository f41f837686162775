#include "wavecurve/curves/hausdorff_distance.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace wavecurve {
namespace {

Contour arbitrary_contour() {
  Contour contour(*rc::gen::inRange(1, 40), 2);
  for (double& value : contour.reshaped()) value = *rc::gen::inRange(-100, 101) / 8.0;
  return contour;
}

RC_GTEST_PROP(HausdorffDistance, IsThatOfEveryPointWithEverySide, ()) {
  const Contour a = arbitrary_contour(), b = arbitrary_contour();
  RC_ASSERT(hausdorff_distance(a, b) == plain::hausdorff_distance(a, b));
}

TEST(HausdorffDistance, IsKnownForSquares) {
  Contour inner(4, 2), outer(4, 2);
  inner << 1, 1, 3, 1, 3, 3, 1, 3;
  outer << 0, 0, 4, 0, 4, 4, 0, 4;
  EXPECT_EQ(hausdorff_distance(inner, inner), 0);
  // The corners of the outer one are farther away than those of the inner one.
  EXPECT_EQ(hausdorff_distance(inner, outer), std::sqrt(2.0));
  EXPECT_EQ(hausdorff_distance(outer, inner), std::sqrt(2.0));
  // Not the distance of the points: (2, 0) lies on a side.
  Contour middle(1, 2), side(2, 2);
  middle << 2, 0;
  side << 0, 0, 4, 0;
  EXPECT_EQ(plain::hausdorff_distance(middle, side), 2);
}

}  // namespace
}  // namespace wavecurve
