#include "wavecurve/curves/detail/anchored_path.hpp"

#include <gtest/gtest.h>

#include "wavecurve/curves/sample_contour.hpp"

namespace wavecurve {
namespace {

Contour rectangle() { return (Contour(4, 2) << 0, 0, 4, 0, 4, 2, 0, 2).finished(); }

TEST(AnchoredPath, HasTheVerticesOfThePathInTheContoursDirection) {
  const Subpath path = polygon(rectangle());
  const AnchoredPath same(path, rectangle());
  ASSERT_EQ(same.vertices().size(), 4U);
  EXPECT_EQ(same.vertices()[1].number, 1U);
  EXPECT_EQ(same.vertices()[1].point, Eigen::Vector2d(4, 0));
  EXPECT_EQ(same.vertices()[2].length, 6);
  EXPECT_TRUE(same.vertices()[3].is_corner);
  const AnchoredPath other(path, rectangle().colwise().reverse());
  EXPECT_EQ(other.vertices()[0].number, 0U);
  EXPECT_EQ(other.vertices()[1].number, 3U);
  EXPECT_EQ(other.vertices()[1].point, Eigen::Vector2d(0, 2));
}

TEST(AnchoredPath, IsSampledFromAnchorToAnchor) {
  const AnchoredPath path(polygon(rectangle()), rectangle());
  EXPECT_EQ(path.lengths_between({1, 3}), (std::vector<double>{6, 6}));
  EXPECT_EQ(path.lengths_between({2}), std::vector<double>{12});
  const Contour points = path.points({1, 3}, {3, 2});
  EXPECT_TRUE(points.isApprox((Contour(5, 2) << 4, 0, 4, 2, 2, 2, 0, 2, 1, 0).finished(), 1e-12))
      << points;
}

TEST(AnchoredPath, ClosesWhatIsOpenAndLeavesOutPoints) {
  Subpath path = polygon(rectangle());
  path.segments.pop_back();
  path.closed = false;
  path.segments.insert(path.segments.begin() + 1, path.segments.front());
  path.segments[1].control.colwise() = path.segments[0].control.col(1);
  const AnchoredPath anchored(path, rectangle());
  ASSERT_EQ(anchored.vertices().size(), 4U);
  EXPECT_EQ(anchored.vertices()[1].number, 2U);
  EXPECT_EQ(anchored.vertices()[3].number, 4U);  // where the closing line starts
}

}  // namespace
}  // namespace wavecurve
