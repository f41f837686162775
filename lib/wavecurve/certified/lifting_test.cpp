#include "wavecurve/certified/lifting.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/certified/find_filter.hpp"

namespace wavecurve::certified {
namespace {

TEST(LiftingSteps, ArePredictAndUpdateForTheFiveThreePair) {
  const LiftingSteps lifting = lifting_steps(find_filter("bspline2.2"), 128);
  ASSERT_EQ(lifting.steps.size(), 2u);
  EXPECT_TRUE(lifting.steps[0].contains(Rational(-1, 2)));
  EXPECT_TRUE(lifting.steps[1].contains(Rational(1, 4)));
}

/// The analysis low-pass filter that the steps make of the constant: the factorisation backwards.
Filter<Ball> rebuilt(const LiftingSteps& lifting) {
  Filter<Ball> even{0, {lifting.factor}}, odd{0, {}};  // in z^2; odd_k stands at 2k + 1
  for (auto s = lifting.steps.rbegin(); s != lifting.steps.rend(); ++s) {
    const bool to_even = (s - lifting.steps.rbegin()) % 2 != 0;
    Filter<Ball>& longer = to_even ? even : odd;
    const Filter<Ball>& shorter = to_even ? odd : even;
    const int first = shorter.first_index - (to_even ? 0 : 1);
    Filter<Ball> sum{first, {}};
    for (int k = first; k <= shorter.last_index() + (to_even ? 1 : 0); ++k) {
      const Ball neighbours = to_even ? shorter[k - 1] + shorter[k] : shorter[k] + shorter[k + 1];
      sum.taps.push_back(longer[k] + *s * neighbours);
    }
    longer = sum;
  }
  Filter<Ball> low{2 * even.first_index, {}};
  for (int n = low.first_index; n <= 2 * even.last_index(); ++n) {
    low.taps.push_back(n % 2 == 0 ? even[n / 2] : odd[(n - 1) / 2]);
  }
  return low;
}

TEST(LiftingSteps, GiveTheFilterBack) {
  const WorkingPrecision precision(200);
  for (const std::string name : {"cdf9.7", "bspline2.2", "bspline4.4"}) {
    const FilterDefinition definition = find_filter(name);
    LiftingSteps lifting;
    try {
      lifting = lifting_steps(definition, 200);
    } catch (const std::domain_error&) {
      continue;
    }
    const Filter<Ball> low = definition.bank(200).analysis_low, again = rebuilt(lifting);
    for (int n = -9; n <= 9; ++n) EXPECT_TRUE(again[n].overlaps(low[n])) << name << " " << n;
  }
  EXPECT_EQ(lifting_steps(find_filter("cdf9.7"), 200).steps.size(), 4u);
}

TEST(LiftingSteps, RefuseFiltersWithoutThem) {
  EXPECT_THROW(lifting_steps(find_filter("db3"), 128), std::domain_error);
  EXPECT_THROW(lifting_steps(find_filter("bspline3.3"), 128), std::domain_error);
}

}  // namespace
}  // namespace wavecurve::certified
