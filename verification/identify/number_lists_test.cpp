#include "verification/identify/number_lists.hpp"

#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::verification {
namespace {

std::vector<double> only_list(std::string_view text) {
  const auto lists = read_number_lists(text);
  EXPECT_EQ(lists.size(), 1u) << text;
  std::vector<double> values;
  for (const PrintedNumber& number : lists.front().numbers) values.push_back(number.to_double());
  return values;
}

const std::vector<double> numbers{0.25, -0.5, 0.75};

TEST(NumberLists, AreReadFromAnyLiteral) {
  for (const char* text : {"0.25\n-0.5\n0.75\n",
                           "0.25, -0.5, 0.75",
                           "0.25 -0.5 0.75",
                           "0.25;-0.5;0.75",
                           "double h[3] = {0.25, -0.5, 0.75};",
                           "static const float h[] = { 0.25f, -0.5f,\n 0.75f };",
                           "h = [0.25, -0.5, 0.75]",
                           "np.array([0.25, -0.5, 0.75])",
                           "h = [0.25 -0.5 0.75];",
                           "h <- c(0.25, -0.5, 0.75)",
                           "h := [0.25, -0.5, 0.75]",
                           "real(8), parameter :: h(0:2) = (/ 0.25d0, -0.5d0, &\n 0.75d0 /)",
                           "data h /0.25d0, -0.5d0, 0.75d0/",
                           "h[0] = 0.25;\nh[1] = -0.5;\nh[2] = 0.75;",
                           "$0.25$ & $-0.5$ & $0.75$ \\\\",
                           "| 0.25 | -0.5 | 0.75 |",
                           "0,25\n-0,5\n0,75",
                           "0.25\n\xE2\x88\x92"
                           "0.5\n0.75",
                           "# taps\n0.25\n-0.5 # the middle\n0.75",
                           "\"h\": [0.25, -0.5, 0.75]",
                           "[0.25,\n -0.5,\n 0.75]",
                           "2.5e-1 -5*10^-1 75/100"}) {
    EXPECT_EQ(only_list(text), numbers) << text;
  }
}

TEST(NumberLists, ColumnsBesideAnIndexAreListsOfTheirOwn) {
  for (const char* text : {"n h g\n0 0.25 1.5\n1 -0.5 2.5\n2 0.75 3.5\n",
                           "| n | h | g |\n|---|---|---|\n| 0 | 0.25 | 1.5 |\n| 1 | -0.5 | 2.5 |\n"
                           "| 2 | 0.75 | 3.5 |\n",
                           "0 & 0.25 & 1.5 \\\\\n1 & -0.5 & 2.5 \\\\\n2 & 0.75 & 3.5 \\\\\n"}) {
    const auto lists = read_number_lists(text);
    ASSERT_EQ(lists.size(), 2u) << text;
    EXPECT_EQ(lists[0].first_index, 0);
    EXPECT_EQ(lists[0].numbers[1].text(), "-0.5");
    EXPECT_EQ(lists[1].numbers[2].text(), "3.5");
  }
}

TEST(NumberLists, SeveralLiteralsKeepTheirNames) {
  const auto lists = read_number_lists("lo = [0.25, 0.5]\nhi = [1.5, 2.5, 3.5]\n");
  ASSERT_EQ(lists.size(), 2u);
  EXPECT_EQ(lists[0].name, "lo");
  EXPECT_EQ(lists[1].name, "hi");
  EXPECT_EQ(lists[1].numbers.size(), 3u);
}

TEST(NumberLists, NoNumberIsRefused) {
  EXPECT_THROW(read_number_lists(""), std::invalid_argument);
  EXPECT_THROW(read_number_lists("no number here\n"), std::invalid_argument);
}

RC_GTEST_PROP(NumberLists, AnyBytesAreReadOrRefused, (const std::string& text)) {
  try {
    for (const NumberList& list : read_number_lists(text)) RC_ASSERT(!list.numbers.empty());
  } catch (const std::invalid_argument&) {
    RC_SUCCEED("refused");
  }
}

}  // namespace
}  // namespace wavecurve::verification
