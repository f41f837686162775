#include "verification/quantities/convention.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

FilterValues values_of(const std::string& filter) {
  return FilterValues(find_table_filter(filter));
}

/// Entries 0 .. n-1 as a table with this convention and ten decimals would print them.
std::vector<EntryToPlace> listed(FilterValues& filter, const Quantity& quantity,
                                 const Convention& convention, int from, int count) {
  std::vector<EntryToPlace> entries;
  for (int n = from; n < from + count; ++n) {
    const double value =
        conventional_value(filter, quantity, convention, EntryIndex(n)).to_double();
    entries.push_back({EntryIndex(n), std::round(value * 1e10) / 1e10, 1e-10});
  }
  return entries;
}

TEST(Convention, EveryCombinationIsRecognisedAndGivesTheSameValues) {
  for (const std::string name : {"db4", "coif1", "cdf9.7"}) {
    FilterValues filter = values_of(name);
    for (const Quantity& quantity : {Quantity::taps, parse_quantity("g"), Quantity::mu}) {
      const auto [first, last] = filter.index_range(quantity);
      for (const bool reversed : {false, true}) {
        for (const bool negated : {false, true}) {
          for (const bool alternating : {false, true}) {
            for (const int half_powers : {0, 1, -2}) {
              const Convention made{reversed, negated, alternating, false, 0, half_powers, false};
              const auto entries = listed(filter, quantity, made, first, last - first + 1);
              const Convention found =
                  recognise_convention(filter, quantity, entries).value_or(Convention{});
              for (const EntryToPlace& entry : entries) {
                EXPECT_NEAR(conventional_value(filter, quantity, found, entry.index).to_double(),
                            entry.value, 1e-9)
                    << name << " " << to_string(quantity) << " "
                    << describe(filter, quantity, made);
              }
            }
          }
        }
      }
    }
  }
}

TEST(Convention, AnIndexFromZeroIsAShift) {
  FilterValues coif2 = values_of("coif2");
  const Convention from_zero{.shift = -4};
  const auto entries = listed(coif2, Quantity::taps, from_zero, 0, 12);
  const auto found = recognise_convention(coif2, Quantity::taps, entries);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->shift, -4);
  EXPECT_EQ(describe(coif2, Quantity::taps, *found), "from 0");
}

TEST(Convention, TheLibrarysOwnAndUnrelatedNumbersHaveNone) {
  FilterValues db4 = values_of("db4");
  EXPECT_FALSE(recognise_convention(db4, Quantity::taps, listed(db4, Quantity::taps, {}, 0, 8)));
  auto entries = listed(db4, Quantity::taps, {.reversed = true}, 0, 8);
  for (EntryToPlace& entry : entries) entry.value += 0.01;
  EXPECT_FALSE(recognise_convention(db4, Quantity::taps, entries));
  EXPECT_FALSE(recognise_convention(db4, Quantity::taps, {entries.front()}));
}

TEST(Convention, OneMisprintDoesNotHideIt) {
  FilterValues db4 = values_of("db4");
  auto entries = listed(db4, Quantity::taps, {.reversed = true}, 0, 8);
  entries[2].value += 0.1;
  EXPECT_TRUE(recognise_convention(db4, Quantity::taps, entries).value().reversed);
}

TEST(Convention, KnownPackagesAreNamed) {
  FilterValues db4 = values_of("db4");
  EXPECT_EQ(known_as(db4, Quantity::taps, {.reversed = true}), "PyWavelets dec_lo, MATLAB LoD");
  EXPECT_EQ(known_as(db4, parse_quantity("g"), {.reversed = true}),
            "PyWavelets dec_hi, MATLAB HiD");
  EXPECT_EQ(known_as(db4, Quantity::taps, {.reversed = true, .negated = true}), "");
}

TEST(Convention, IsStatedInWords) {
  const StatedConvention stated = parse_convention("reversed, from 0, *sqrt2");
  EXPECT_TRUE(stated.convention.reversed);
  EXPECT_TRUE(stated.convention.stated);
  EXPECT_TRUE(stated.from_zero);
  EXPECT_EQ(stated.convention.half_powers, 1);
  EXPECT_EQ(parse_convention("shift -4").shift, -4);
  for (const char* wrong :
       {"upside down", "shift 1/2", "shift (2, 1)", "shift", "*2/first", "/first"}) {
    EXPECT_THROW(parse_convention(wrong), std::invalid_argument) << wrong;
  }
}

}  // namespace
}  // namespace wavecurve::verification
