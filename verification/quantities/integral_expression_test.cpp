#include "verification/quantities/integral_expression.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

TEST(IntegralExpression, IsReadAndWritten) {
  for (const auto& [text, meaning, written] : {
           std::tuple{"phi' phi(l) phi(m)", "int phi'(x) phi(x - l) phi(x - m) dx",
                      "phi', phi, phi"},
           {"phi', phi, phi, phi~", "int phi'(x) phi(x - l) phi(x - m) phi~(x - n) dx",
            "phi', phi, phi, phi~"},
           {"phi(l) phi'", "int phi'(x) phi(x - l) dx", "phi', phi"},
           {"x^2 phi(k) psi''", "int x^2 psi''(x) phi(x - l) dx", "x^2, psi'', phi"},
           {"x * φ * x^(3) * ψ(4x - l)", "int x^4 phi(x) psi(4x - l) dx", "x^4, phi, psi(4x - l)"},
           {"phi phi phi'(k)", "int phi(x) phi(x) phi'(x - l) dx", "phi, phi, phi'(l)"},
           {"psi(2x) phi(x-a)", "int psi(2x) phi(x - l) dx", "psi(2x), phi(l)"},
           {"x^3 phi", "int x^3 phi(x) dx", "x^3, phi"},
       }) {
    const ProductIntegral integral = parse_integral(text);
    EXPECT_EQ(name_of(integral), meaning);
    EXPECT_EQ(to_string(integral), written);
    EXPECT_EQ(name_of(parse_integral(to_string(integral))), meaning);
  }
  EXPECT_EQ(name_of(parse_integral("phi(k) phi'(l)", DyadicInterval{0, 1, 0})),
            "int phi(x - l) phi'(x - m) dx over [0, 1]");
  EXPECT_EQ(name_of(parse_integral("phi phi'", DyadicInterval{0, 1, 0})),
            "int phi(x) phi'(x - l) dx over [0, 1]");
}

void expect_refusal(const std::string& text, const std::string& part,
                    const std::optional<DyadicInterval>& interval = {}) {
  try {
    parse_integral(text, interval);
    ADD_FAILURE() << text;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(IntegralExpression, TellsTheColumnOfWhatIsWrong) {
  expect_refusal("phi' ph(l)", "column 6: expected phi or psi");
  expect_refusal("φ' ψ'' q", "column 8: expected phi or psi");
  expect_refusal("", "column 1: expected phi or psi");
  expect_refusal("x^2", "column 4: expected phi or psi");
  expect_refusal("phi phi(2)", "column 10: expected 'x'");
  expect_refusal("phi phi(3x - l)", "column 9: expected a power of two up to 1024");
  expect_refusal("phi phi(l) phi(l)", "column 16: expected a letter that is not used twice");
  expect_refusal("phi(l) phi(m)", "column 14: expected a factor without a letter");
  expect_refusal("phi'''''''''", "column 13: expected at most 8 primes");
  expect_refusal("phi^(9) phi", "column 6: expected an order of a derivative from 0 to 8");
  expect_refusal("phi phi phi phi phi", "column 17: expected the end: at most 4 factors");
  expect_refusal("phi phi phi phi", "at most 3 factors on an interval", DyadicInterval{0, 1, 0});
  expect_refusal("x^21 phi", "column 3: expected a power of x from 0 to 20");
  expect_refusal("x^15 x^6 phi", "add up to at most 20");
}

TEST(IntegralExpression, IntervalsHaveDyadicEnds) {
  EXPECT_EQ(parse_interval("0,1"), (DyadicInterval{0, 1, 0}));
  EXPECT_EQ(parse_interval("-1/2, 0.75"), (DyadicInterval{-2, 3, 2}));
  for (const std::string text :
       {"", "0", "0,1/3", "0,1,2", "a,b", "0,0.1", "0,1/2048", "0,1e9", "1,0", "2,2", ","}) {
    EXPECT_THROW(parse_interval(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace wavecurve::verification
