#include "wavecurve/filters/detail/bad_value.hpp"

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace wavecurve {
namespace {

std::string refusal(const std::function<void()>& check) {
  try {
    check();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(BadValue, SmallNumbersCanBeRead) {
  EXPECT_EQ(must_be("step", -1e-9, "above 0"), "step is -1e-09, but must be above 0");
  EXPECT_EQ(must_be("step", 0.1, "above 1"), "step is 0.1, but must be above 1");
  EXPECT_EQ(must_be("frames", 1, "at least 2"), "frames is 1, but must be at least 2");
}

TEST(BadValue, TextsStandInQuotesAndAreCut) {
  EXPECT_EQ(must_be("output", "a.b", "an .svg file"), "output is 'a.b', but must be an .svg file");
  EXPECT_EQ(value_text("two\nlines\x7f, \u03bc"), "'two\uFFFDlines\uFFFD, \u03bc'");
  EXPECT_EQ(value_text(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
  EXPECT_EQ(value_text(std::string(61, 'x')), "'" + std::string(60, 'x') + "...'");
}

TEST(BadValue, BoundsThemselvesAreGood) {
  EXPECT_EQ(refusal([] { check_at_least("n", 2, 2); }), "");
  EXPECT_EQ(refusal([] { check_at_least("n", 1, 2); }), "n is 1, but must be at least 2");
  EXPECT_EQ(refusal([] { check_between("n", 0, 0, 3), check_between("n", 3, 0, 3); }), "");
  EXPECT_EQ(refusal([] { check_between("n", -1, 0, 3); }), "n is -1, but must be from 0 to 3");
  EXPECT_EQ(refusal([] { check_between("n", 4, 0, 3); }), "n is 4, but must be from 0 to 3");
  EXPECT_EQ(refusal([] { check_at_least("x", 0.0, 0.0); }), "");
  EXPECT_EQ(refusal([] { check_at_least("x", -1e-9, 0.0); }),
            "x is -1e-09, but must be finite and at least 0");
  EXPECT_EQ(refusal([] { check_above_zero("x", 1e-300); }), "");
  EXPECT_EQ(refusal([] { check_above_zero("x", 0); }), "x is 0, but must be finite and above 0");
}

TEST(BadValue, WhatIsNotFiniteIsRefused) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([] { check_above_zero("x", infinity); }),
            "x is inf, but must be finite and above 0");
  EXPECT_EQ(refusal([] { check_at_least("x", nan, 0.0); }),
            "x is nan, but must be finite and at least 0");
}

TEST(BadValue, UnknownNamesComeWithTheKnown) {
  const std::vector<std::string> known{"walk", "trot"};
  EXPECT_EQ(unknown_name("gait", "tort", known), "unknown gait 'tort'; known: walk, trot");
  const std::string_view views[] = {"a", "b"};
  EXPECT_EQ(unknown_name("model", "", views), "unknown model ''; known: a, b");
}

}  // namespace
}  // namespace wavecurve
