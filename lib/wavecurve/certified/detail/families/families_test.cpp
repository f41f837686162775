#include "wavecurve/certified/detail/families/families.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/certified/detail/relations.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/filters/autocorrelation.hpp"

namespace wavecurve::certified {
namespace {

constexpr long bits = 160;

class EveryFilter : public testing::TestWithParam<std::string> {};

TEST_P(EveryFilter, SatisfiesEveryRelation) {
  const auto bank = find_filter(GetParam()).bank(bits);
  const WorkingPrecision precision(2 * bits);
  for (const auto& relation : filter_relations(bank, sqrt(Ball(2)))) {
    EXPECT_TRUE(relation.residual.contains_zero()) << relation.equation;
    // A wide enclosure would contain zero without saying anything. The longest sums, alternating
    // moments k^(N-1) with k < 2N, lose N log2(2N) bits of the taps' accuracy.
    const double lost = bank.vanishing_moments * std::log2(2.0 * bank.synthesis_low.size()) + 20;
    EXPECT_LT(relation.residual.radius_double(), std::exp2(lost - bits)) << relation.equation;
  }
}

TEST_P(EveryFilter, HasTheAccuracyAskedFor) {
  for (const Ball& tap : find_filter(GetParam()).bank(bits).synthesis_low.taps) {
    EXPECT_TRUE(tap.is_exact() || tap.accuracy_bits() >= bits);
  }
}

TEST_P(EveryFilter, EnclosesTheTapsOfAHigherPrecision) {
  const auto definition = find_filter(GetParam());
  const auto bank = definition.bank(64), truth = definition.bank(2 * bits);
  for (int i = 0; i < truth.synthesis_low.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_TRUE(bank.synthesis_low.taps[k].contains(truth.synthesis_low.taps[k])) << i;
  }
}

TEST_P(EveryFilter, HasExactlyTheClaimedZerosAtPi) {
  const auto bank = find_filter(GetParam()).bank(bits);
  const WorkingPrecision precision(2 * bits);
  EXPECT_EQ(zeros_at_pi(bank.synthesis_low), bank.vanishing_moments);
  EXPECT_EQ(zeros_at_pi(bank.analysis_low), bank.dual_vanishing_moments);
}

TEST_P(EveryFilter, ExactAutocorrelationLiesInTheEnclosure) {
  const auto definition = find_filter(GetParam());
  if (!definition.exact) return;
  const WorkingPrecision precision(2 * bits);
  const auto bank = definition.bank(bits);
  const auto alpha = autocorrelation(bank.synthesis_low);
  ASSERT_EQ(alpha.size(), definition.exact->synthesis.size());
  for (int n = 0; n < alpha.size(); ++n) {
    EXPECT_TRUE(alpha[n].contains(definition.exact->synthesis[n])) << n;
  }
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& c : name) c = c == '.' ? '_' : c;
  return name;
}

const std::vector<std::string> tested = {
    "db1",        "db2",        "db3",        "db4",         "db7",        "db10",
    "db20",       "db38",       "sym2",       "sym4",        "sym7",       "sym11",
    "sym16",      "sym20",      "coif1",      "coif2",       "coif3",      "coif4",
    "coif5",      "coif9",      "coif17",     "cdf9.7",      "bior5.5",    "bior6.8",
    "rbio1.3",    "rbio4.4",    "rbio6.8",    "bspline1.1",  "bspline1.5", "bspline2.2",
    "bspline3.1", "bspline4.4", "bspline7.3", "bspline20.20"};

INSTANTIATE_TEST_SUITE_P(Families, EveryFilter, testing::ValuesIn(tested), test_name);

TEST(Families, HaveATestedMember) {
  for (const Family& family : families()) {
    EXPECT_TRUE(std::ranges::any_of(tested, [&](const std::string& name) {
      return family.define(name).has_value();
    })) << family.names;
  }
}

TEST(Coiflets, ScalingFunctionHasVanishingMoments) {
  for (int order = 1; order <= 6; ++order) {
    const auto low = find_filter("coif" + std::to_string(order)).bank(bits).synthesis_low;
    const WorkingPrecision precision(2 * bits);
    EXPECT_EQ(low.first_index, -2 * order);
    for (int j = 1; j < 2 * order; ++j) {
      Ball moment(0);
      for (int n = low.first_index; n <= low.last_index(); ++n) {
        Ball power(1);
        for (int i = 0; i < j; ++i) power *= Ball(n);
        moment += power * low[n];
      }
      EXPECT_TRUE(moment.contains_zero()) << order << " " << j;
      EXPECT_LT(moment.radius_double(), 1e-25);
    }
  }
}

TEST(Daubechies, FirstOrdersHaveTheirClosedForms) {
  const WorkingPrecision precision(bits);
  const auto db2 = find_filter("D4").bank(bits).synthesis_low;
  const Ball root_three = sqrt(Ball(3)), scale = Ball(4) * sqrt(Ball(2));
  const Ball closed[] = {Ball(1) + root_three, Ball(3) + root_three, Ball(3) - root_three,
                         Ball(1) - root_three};
  for (int n = 0; n < 4; ++n) EXPECT_TRUE(db2[n].overlaps(closed[n] / scale)) << n;
}

TEST(Symlets, FirstTwoAreDaubechies) {
  for (const int order : {2, 3}) {
    const auto sym = find_filter("sym" + std::to_string(order)).bank(bits).synthesis_low;
    const auto db = find_filter("db" + std::to_string(order)).bank(bits).synthesis_low;
    for (int n = 0; n < sym.size(); ++n) EXPECT_TRUE(sym[n].overlaps(db[n])) << order << " " << n;
  }
}

TEST(Names, AliasesLeadToTheCanonicalName) {
  EXPECT_EQ(canonical_filter_name("D8"), "db4");
  EXPECT_EQ(canonical_filter_name("K2"), "coif2");
  EXPECT_EQ(canonical_filter_name("haar"), "db1");
  EXPECT_EQ(canonical_filter_name("D76"), "db38");
  EXPECT_EQ(canonical_filter_name("K5"), "coif5");
  EXPECT_EQ(canonical_filter_name("bior4.4"), "cdf9.7");
  EXPECT_EQ(canonical_filter_name("bspline3.5"), "bspline3.5");
  for (const auto& [alias, name] :
       std::vector<std::pair<std::string, std::string>>{{"d2", "db1"},
                                                        {"d8", "db4"},
                                                        {"c6", "coif1"},
                                                        {"c30", "coif5"},
                                                        {"la8", "sym4"},
                                                        {"la14", "sym7"},
                                                        {"la20", "sym10"},
                                                        {"legall", "bspline2.2"},
                                                        {"cdf5.3", "bspline2.2"},
                                                        {"bior1.5", "bspline1.5"},
                                                        {"bior2.8", "bspline2.8"},
                                                        {"bior3.9", "bspline3.9"},
                                                        {"antonini", "cdf9.7"},
                                                        {"bior5.5", "bior5.5"},
                                                        {"rbio2.2", "rbio2.2"}}) {
    EXPECT_EQ(canonical_filter_name(alias), name);
  }
}

TEST(Names, EachStandsForOneFilter) {
  std::set<std::string> seen;
  for (const Family& family : families()) {
    for (const std::string& name : family.members) {
      EXPECT_TRUE(seen.insert(name).second) << name;
      EXPECT_EQ(canonical_filter_name(name), name);
    }
    for (const auto& [alias, name] : family.aliases) {
      EXPECT_TRUE(seen.insert(alias).second) << alias;
      EXPECT_EQ(canonical_filter_name(alias), name);
    }
  }
}

TEST(Names, ReversedPairsExchangeTheSides) {
  int pairs = 0;
  for (const Family& family : families()) {
    for (const std::string& name : family.members) {
      if (!name.starts_with("rbio")) continue;
      const auto reversed = find_filter(name).bank(bits);
      const auto pair = find_filter("bior" + name.substr(4)).bank(bits);
      const WorkingPrecision precision(2 * bits);
      EXPECT_EQ(reversed.name, name);
      const auto same = [](const Filter<Ball>& a, const Filter<Ball>& b) {
        return a.first_index == b.first_index &&
               std::ranges::equal(a.taps, b.taps,
                                  [](const Ball& x, const Ball& y) { return x.overlaps(y); });
      };
      EXPECT_TRUE(same(reversed.analysis_low, pair.synthesis_low)) << name;
      EXPECT_TRUE(same(reversed.synthesis_low, pair.analysis_low)) << name;
      EXPECT_TRUE(same(reversed.synthesis_high, pair.analysis_high)) << name;
      EXPECT_EQ(reversed.vanishing_moments, pair.dual_vanishing_moments);
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 15);  // as many as PyWavelets and MATLAB have
}

TEST(HalfbandPairs, HaveTheLengthsOfTheirDefinition) {
  const auto lengths = [](const char* name) {
    const auto bank = find_filter(name).bank(bits);
    return std::pair(bank.analysis_low.size(), bank.synthesis_low.size());
  };
  EXPECT_EQ(lengths("cdf9.7"), std::pair(9, 7));
  EXPECT_EQ(lengths("bior5.5"), std::pair(9, 11));
  EXPECT_EQ(lengths("bior6.8"), std::pair(17, 11));
}

TEST(HalfbandPairs, ShareTheRootsAsThePublishedTablesDo) {
  // The middle taps of synthesis_low that MATLAB and PyWavelets print, to 11 decimals: half a unit
  // of the last for their own error, which docs/conventions.md states, and half for cutting here.
  constexpr double tolerance = 1e-11;
  for (const auto& [name, printed] : {std::pair("cdf9.7", 0.78848561641),
                                      {"bior5.5", 0.89950610975},
                                      {"bior6.8", 0.75890772945}}) {
    EXPECT_NEAR(find_filter(name).bank(bits).synthesis_low[0].to_double(), printed, tolerance);
  }
}

TEST(Names, FiltersOfOtherPackagesAreRefusedWithAReason) {
  const auto message = [](const char* name) {
    try {
      find_filter(name);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const char* name :
       {"fk4", "fk22", "dmey", "beyl", "vaid", "mb4", "mb4.2", "bl14", "han2.3"}) {
    EXPECT_NE(message(name).find("JSON file"), std::string::npos) << message(name);
  }
  EXPECT_EQ(message("fk8"),
            "filter 'fk8' is a Fejer-Korovkin filter, whose taps have no closed "
            "definition here; give them as a JSON file");
  EXPECT_NE(message("morl").find("a continuous wavelet"), std::string::npos);
  for (const char* name : {"blah", "fkx", "bior4.6", "rbio4.6", "rbio", "la6", "c7", "d7"}) {
    EXPECT_TRUE(
        message(name).starts_with("unknown filter '" + std::string(name) + "'; known: db1-db38"))
        << message(name);
  }
}

TEST(Names, WhatIsNoFilterIsRefused) {
  for (const char* bad :
       {"", "db", "db0", "db39", "db04", "db4 ", "D7", "D78", "sym1", "sym21", "coif18",
        "bspline3.4", "bspline0.2", "bspline3", "bspline101.1", "cdf9.9", "db-4"}) {
    EXPECT_THROW(find_filter(bad), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace wavecurve::certified
