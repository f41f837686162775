#include "wavecurve/certified/detail/relations.hpp"

#include <gtest/gtest.h>

namespace wavecurve::certified {
namespace {

using Taps = Filter<Rational>;

FilterBank<Rational> bank_of(const Taps& analysis, const Taps& synthesis, int dual_moments = 0,
                             int moments = 0) {
  auto bank = make_filter_bank("test", analysis, synthesis);
  bank.vanishing_moments = moments;
  bank.dual_vanishing_moments = dual_moments;
  return bank;
}

/// The equations that a bank of the sum 2 violates, in the order of the list.
std::vector<std::string> violated(const FilterBank<Rational>& bank) {
  std::vector<std::string> equations;
  for (const auto& relation : filter_relations(bank, Rational(2))) {
    if (!relation.residual.is_zero()) equations.push_back(relation.equation);
  }
  EXPECT_EQ(satisfies_relations(bank, Rational(2)), equations.empty());
  return equations;
}

std::string lag(int n) {
  return "sum_k analysis_low_k synthesis_low_{k+" + std::to_string(n) +
         "} = " + (n == 0 ? "1" : "0");
}

using Equations = std::vector<std::string>;

const Taps haar{0, {1, 1}};
const Taps linear{-1, {Rational(1, 2), 1, Rational(1, 2)}};
const Taps linear_dual{
    -2, {Rational(-1, 4), Rational(1, 2), Rational(3, 2), Rational(1, 2), Rational(-1, 4)}};

TEST(FilterRelations, HoldForHaarAndTheLinearSpline) {
  EXPECT_EQ(violated(bank_of(haar, haar, 1, 1)), Equations{});
  EXPECT_EQ(violated(bank_of(linear_dual, linear, 2, 2)), Equations{});
}

// Each bank below breaks the equations named and no others.

TEST(FilterRelations, NameTheSumOfEitherSide) {
  const Taps one{0, {1}}, two{0, {2}}, half{0, {Rational(1, 2)}}, four{0, {4}};
  EXPECT_EQ(violated(bank_of(one, two)), Equations{"sum_k analysis_low_k = sqrt 2"});
  EXPECT_EQ(violated(bank_of(half, four)),
            (Equations{"sum_k synthesis_low_k = sqrt 2", "sum_k analysis_low_k = sqrt 2"}));
  EXPECT_EQ(violated(bank_of(two, one)), Equations{"sum_k synthesis_low_k = sqrt 2"});
}

TEST(FilterRelations, NameTheMomentThatDoesNotVanishOnItsSide) {
  EXPECT_EQ(violated(bank_of(haar, haar, 2, 2)), Equations{"sum_k (-1)^k k^1 synthesis_low_k = 0"});
  EXPECT_EQ(violated(bank_of(linear_dual, linear, 2, 3)),
            Equations{"sum_k (-1)^k k^2 synthesis_low_k = 0"});
  EXPECT_EQ(violated(bank_of(linear_dual, linear, 3, 2)),
            Equations{"sum_k (-1)^k k^2 analysis_low_k = 0"});
}

TEST(FilterRelations, NameTheLagThatIsNotOrthogonal) {
  // The even lags of an autocorrelation with these sums: 2 at 0, 1 at 2.
  const Taps spread{0, {1, 0, 1}};
  EXPECT_EQ(violated(bank_of(spread, spread)), Equations{lag(2)});
  const Taps both_sides{-2, {1, 0, 1, 1, -1, 0}};
  EXPECT_EQ(violated(bank_of(haar, both_sides, 1, 0)), (Equations{lag(-2), lag(2)}));
  EXPECT_EQ(violated(bank_of(both_sides, haar, 0, 1)), (Equations{lag(-2), lag(2)}));
  const Taps short_of_norm{0, {Rational(1, 2), 1, Rational(1, 2)}};
  EXPECT_EQ(violated(bank_of(short_of_norm, short_of_norm)), (Equations{lag(0), lag(2)}));
}

TEST(ViolatedRelation, IsTheFirstThatIsProved) {
  const auto bank_with = [](const Ball& second) {
    const Ball half_root = sqrt(Ball(2)) / Ball(2);
    const Filter<Ball> low{0, {half_root, second}};
    auto bank = make_filter_bank("test", low, low);
    bank.vanishing_moments = bank.dual_vanishing_moments = 1;
    return bank;
  };
  const WorkingPrecision precision(128);
  const Ball right = sqrt(Ball(2)) / Ball(2);
  const Rational small = Rational::power_of_two(-40);
  EXPECT_FALSE(violated_relation(bank_with(right)));
  EXPECT_EQ(violated_relation(bank_with(right + Ball(small)))->equation,
            "sum_k synthesis_low_k = sqrt 2");
  Ball wide = right + Ball(small);
  arb_add_error(wide.get(), Ball(small).get());
  EXPECT_FALSE(violated_relation(bank_with(wide))) << "the enclosure admits the right tap";
}

TEST(ZerosAtPi, AreCounted) {
  EXPECT_EQ(zeros_at_pi(Taps{0, {2}}), 0);
  EXPECT_EQ(zeros_at_pi(haar), 1);
  EXPECT_EQ(zeros_at_pi(linear), 2);
  EXPECT_EQ(zeros_at_pi(Taps{0, {1, 0, 1}}), 0);
  EXPECT_EQ(zeros_at_pi(Taps{0, {1, 0, -1}}), 1) << "(1 + x)(1 - x)";
  // All zeros are used up: the alternating sum of no taps would vanish at every order.
  EXPECT_EQ(zeros_at_pi(Taps{0, {0, 0, 0}}), 2);
}

}  // namespace
}  // namespace wavecurve::certified
