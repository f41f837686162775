#include "wavecurve/filters/find_filter_bank.hpp"

#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wavecurve/certified/detail/filter_table_source.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve {
namespace {

template <class Scalar>
std::optional<Scalar> nearest(const certified::Ball& tap);
template <>
std::optional<double> nearest(const certified::Ball& tap) {
  return certified::round_to_double(tap);
}
template <>
std::optional<float> nearest(const certified::Ball& tap) {
  return certified::round_to_float(tap);
}

template <class Scalar>
bool is_correctly_rounded(const std::string& name) {
  constexpr long bits = 200;
  const auto bank = find_filter_bank<Scalar>(name);
  const auto exact = certified::find_filter(name).bank(bits);
  const auto agree = [](const Filter<Scalar>& table, const Filter<certified::Ball>& enclosure) {
    if (table.first_index != enclosure.first_index || table.size() != enclosure.size())
      return false;
    for (std::size_t i = 0; i < table.taps.size(); ++i) {
      if (nearest<Scalar>(enclosure.taps[i]) != table.taps[i]) return false;
    }
    return true;
  };
  return agree(bank.analysis_low, exact.analysis_low) &&
         agree(bank.synthesis_low, exact.synthesis_low) &&
         agree(bank.analysis_high, exact.analysis_high) &&
         agree(bank.synthesis_high, exact.synthesis_high) &&
         bank.vanishing_moments == exact.vanishing_moments &&
         bank.dual_vanishing_moments == exact.dual_vanishing_moments;
}

TEST(FilterTables, AreWhatTheGeneratorWrites) {
  const std::string committed =
      io::read_file(WAVECURVE_SOURCE_DIR "/lib/wavecurve/filters/filter_tables.cpp");
  EXPECT_TRUE(certified::filter_table_source() == committed)
      << "run build/release/bin/generate_filter_tables lib/wavecurve/filters/filter_tables.cpp";
}

TEST(FilterTables, AreReadBackWithTheirAliases) {
  for (const char* name : {"db4", "D8", "coif2", "K2", "haar", "sym8", "bior4.4", "bior5.5",
                           "bior6.8", "rbio3.1", "rbio6.8", "legall", "la16", "c12"}) {
    EXPECT_TRUE(is_correctly_rounded<double>(name)) << name;
    EXPECT_TRUE(is_correctly_rounded<float>(name)) << name;
  }
}

RC_GTEST_PROP(SplineFilter, EveryTapIsCorrectlyRounded, ()) {
  const int order = *rc::gen::inRange(1, 30);
  const int dual = 2 * *rc::gen::inRange(1, 15) - order % 2;
  const std::string name = "bspline" + std::to_string(order) + "." + std::to_string(dual);
  RC_ASSERT(is_correctly_rounded<double>(name));
  RC_ASSERT(is_correctly_rounded<float>(name));
}

TEST(FindFilterBank, RefusesWhatItDoesNotKnow) {
  for (const char* bad :
       {"", "db39", "bspline2.3", "bspline101.101", "bspline0.2", "rbio2.3", "fk8", "nope"}) {
    EXPECT_THROW(find_filter_bank(bad), std::invalid_argument) << bad;
  }
}

TEST(FindFilterBank, HighPassFollowsTheConjugateMirror) {
  const auto bank = find_filter_bank("cdf9.7");
  for (int k = -10; k <= 10; ++k) {
    const double sign = k % 2 == 0 ? 1 : -1;
    EXPECT_EQ(bank.synthesis_high[k], sign * bank.analysis_low[1 - k]);
    EXPECT_EQ(bank.analysis_high[k], sign * bank.synthesis_low[1 - k]);
  }
}

}  // namespace
}  // namespace wavecurve
