#include "verification/quantities/other_solution.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve::verification {
namespace {

std::vector<double> taps_of(const std::string& filter) {
  return find_filter_bank(filter).synthesis_low.taps;
}

TEST(DescribeSolution, ACoifletIsOneByItsMoments) {
  EXPECT_NE(describe_solution(taps_of("coif2")).find("a coiflet of this length"),
            std::string::npos);
  // The other solution of length 6, with the root of 15 (Daubechies 1993).
  const double r = std::sqrt(15.0), s = 16 * std::sqrt(2.0);
  const std::vector<double> other{(r - 3) / s,     (1 - r) / s,  (6 - 2 * r) / s,
                                  (2 * r + 6) / s, (r + 13) / s, (9 - r) / s};
  EXPECT_NE(describe_solution(other).find("a coiflet of this length"), std::string::npos)
      << describe_solution(other);
}

TEST(DescribeSolution, ASymletIsAChoiceOfRoots) {
  EXPECT_NE(describe_solution(taps_of("sym6")).find("with 6 vanishing moments"), std::string::npos);
  std::vector<double> twice = taps_of("db5");  // with the sum 2
  for (double& tap : twice) tap *= std::sqrt(2.0);
  EXPECT_NE(describe_solution(twice).find("with 5 vanishing moments"), std::string::npos);
}

TEST(DescribeSolution, OtherNumbersAreNone) {
  EXPECT_EQ(describe_solution({0.1, 0.2, 0.3, 0.4}), "");
  EXPECT_EQ(describe_solution({}), "");
  EXPECT_EQ(describe_solution({1, -1, 1, -1}), "");
  EXPECT_EQ(describe_solution(taps_of("cdf9.7")), "");
}

}  // namespace
}  // namespace wavecurve::verification
