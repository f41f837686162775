#include "verification/checker/atlas.hpp"

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

AtlasEntry judged(const std::string& rows) {
  return atlas_entry(
      check_table(parse_published_table("filter,quantity,index,printed\n" + rows, "t.csv")));
}

TEST(Atlas, CountsWhatIsRightAndWrongAndToWhichDigit) {
  const AtlasEntry entry =
      judged("db2,h,0,0.482963\ndb2,h,1,0.836516\ndb2,h,2,0.224144\ndb2,h,3,-0.130410\n");
  EXPECT_EQ(entry.numbers, 4);
  EXPECT_EQ(entry.right, 3);
  EXPECT_EQ(entry.wrong, 1);
  EXPECT_EQ(entry.right_digits, 2);  // off by 0.001 where the largest is 0.8
}

TEST(Atlas, NamesConventionsAndMisprints) {
  const AtlasEntry reversed =
      judged("db2,h,0,-0.129410\ndb2,h,1,0.224144\ndb2,h,2,0.836516\ndb2,h,3,0.482963\n");
  ASSERT_EQ(reversed.causes.size(), 1u);
  EXPECT_EQ(reversed.causes.front(), "db2 h: reversed (PyWavelets dec_lo, MATLAB LoD)");
  const AtlasEntry misprint =
      judged("db2,h,0,0.482963\ndb2,h,1,0.836516\ndb2,h,2,0.224144\ndb2,h,3,0.129410\n");
  ASSERT_EQ(misprint.causes.size(), 1u);
  EXPECT_EQ(misprint.causes.front(), "db2 h_3: a lost sign");
}

TEST(Atlas, ThePageHasALineForEachTableAndItsSource) {
  AtlasEntry entry;
  entry.file = "a.csv";
  entry.title = "A | B";
  entry.source = "a book";
  entry.numbers = 3;
  entry.right = 3;
  const std::string page = atlas_page({entry});
  EXPECT_NE(page.find("| `a.csv`: A \\| B | 3 | 3 | 0 |"), std::string::npos) << page;
  EXPECT_NE(page.find("- `a.csv`: a book"), std::string::npos);
}

}  // namespace
}  // namespace wavecurve::verification
