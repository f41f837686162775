#include "verification/checker/judge_doubles.hpp"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve::verification {
namespace {

/// The taps as programs print doubles, in the fewest digits that give them back; the last moved by so many times 2^-53.
CheckedTable checked_taps(const std::string& name, int moved) {
  std::string text = "filter,quantity,index,printed\n";
  const Filter<double> low = find_filter_bank(name).synthesis_low;
  for (int n = low.first_index; n <= low.last_index(); ++n) {
    const double tap = low[n] + (n == low.last_index() ? moved * 0x1p-53 : 0);
    text += fmt::format("{},h,{},{}\n", name, n, tap);
  }
  return check_table(parse_published_table(text, "doubles"));
}

TEST(JudgeDoubles, CertifiesTheNearestDoublesWhateverTheirDigits) {
  for (const std::string name : {"db3", "coif2", "cdf9.7"}) {
    const CheckedTable table = checked_taps(name, 0);
    EXPECT_FALSE(table.is_right()) << name << ": as decimals some digits are off";
    EXPECT_TRUE(judged_as_doubles(table).is_right()) << name;
  }
}

TEST(JudgeDoubles, CertifiesNoNeighbour) {
  for (const int moved : {-1, 1, 100}) {
    const CheckedTable table = judged_as_doubles(checked_taps("db3", moved));
    EXPECT_FALSE(table.is_right());
    EXPECT_NE(table.rows.back().verdict, PrintVerdict::certified);
    EXPECT_EQ(table.counts().at(PrintVerdict::certified), 5);
  }
}

}  // namespace
}  // namespace wavecurve::verification
