#include "wavecurve/certified/rational.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "wavecurve/certified/random_numbers_test.hpp"

namespace wavecurve::certified {
namespace {

__extension__ typedef __int128 Wide;  // GCC and Clang have it, the standard does not

std::string digits_of(Wide n) {
  if (n < 0) return "-" + digits_of(-n);
  const std::string last(1, static_cast<char>('0' + static_cast<int>(n % 10)));
  return n < 10 ? last : digits_of(n / 10) + last;
}

/// p/q in lowest terms, as Rational::to_string() writes it.
std::string fraction(Wide p, Wide q) {
  Wide a = p < 0 ? -p : p, b = q < 0 ? -q : q;
  while (b != 0) a = std::exchange(b, a % b);
  if (q < 0) a = -a;
  return digits_of(p / a) + (q / a == 1 ? "" : "/" + digits_of(q / a));
}

struct Fraction {
  long p, q;
};

Fraction random_fraction(RandomNumbers& random) {
  const long p = random.whole(), q = random.whole();
  return {p, q == 0 ? 1 : q};
}

TEST(Rational, ArithmeticIsThatOfWideIntegers) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const Fraction x = random_fraction(random), y = random_fraction(random);
    const Rational a(x.p, x.q), b(y.p, y.q);
    const Wide xp = x.p, xq = x.q, yp = y.p, yq = y.q;
    ASSERT_EQ(a.to_string(), fraction(xp, xq));
    ASSERT_EQ((a + b).to_string(), fraction(xp * yq + yp * xq, xq * yq));
    ASSERT_EQ((a - b).to_string(), fraction(xp * yq - yp * xq, xq * yq));
    ASSERT_EQ((a * b).to_string(), fraction(xp * yp, xq * yq));
    if (yp != 0) {
      ASSERT_EQ((a / b).to_string(), fraction(xp * yq, xq * yp));
    }
    ASSERT_EQ((-a).to_string(), fraction(-xp, xq));
    const Wide difference = (xp * yq - yp * xq) * ((xq < 0) == (yq < 0) ? 1 : -1);
    ASSERT_EQ(a < b, difference < 0);
    ASSERT_EQ(a > b, difference > 0);
    ASSERT_EQ(a == b, difference == 0);
    ASSERT_EQ(a.sign(), fraction(xp, xq).starts_with('-') ? -1 : xp != 0);
    ASSERT_EQ(a.is_zero(), xp == 0);
    ASSERT_EQ(a.abs().to_string(), fraction(xp < 0 ? -xp : xp, xq < 0 ? -xq : xq));
  }
}

TEST(Rational, LongFractionsObeyTheLawsOfAField) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const Rational a = random.rational(), b = random.rational(), c = random.rational();
    ASSERT_EQ((a + b) - b, a);
    ASSERT_EQ(a * (b + c), a * b + a * c);
    if (!b.is_zero()) {
      ASSERT_EQ((a * b) / b, a);
    }
    ASSERT_EQ(a < b, (a - b).sign() < 0);
    ASSERT_EQ(a == b, (a - b).is_zero());
    ASSERT_EQ(a.abs(), a < Rational(0) ? -a : a);
  }
}

TEST(Rational, BothOperandsMayBeTheSame) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const Rational value = random.rational(), copy = value;
    Rational x = value;
    x += x;
    ASSERT_EQ(x, value * Rational(2));
    x = value;
    x *= x;
    ASSERT_EQ(x, value * copy);
    x = value;
    x -= x;
    ASSERT_TRUE(x.is_zero());
    x = value;
    if (x.is_zero()) {
      ASSERT_THROW(x /= x, std::domain_error);
    } else {
      ASSERT_EQ(x /= x, Rational(1));
    }
  }
}

TEST(Rational, SurvivesAssignmentToItself) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const Rational value = random.rational();
    Rational x = value;
    Rational& same = x;
    x = same;
    ASSERT_EQ(x, value);
    x = std::move(same);
    ASSERT_EQ(x, value);
    std::swap(x, same);
    ASSERT_EQ(x, value);
    const Rational taken = std::move(x);
    ASSERT_EQ(taken, value);
    x = random.rational();  // what was moved from can be used again
    ASSERT_EQ(x + taken - taken, x);
    ASSERT_EQ(taken, value) << "the two share nothing";
  }
}

TEST(Rational, HasTheLargestAndTheSmallestIntegers) {
  constexpr long smallest = std::numeric_limits<long>::min();
  constexpr long largest = std::numeric_limits<long>::max();
  EXPECT_EQ(Rational(smallest).to_string(), "-9223372036854775808");
  EXPECT_EQ(Rational(smallest, smallest), Rational(1));
  EXPECT_EQ(Rational(1, smallest).to_string(), "-1/9223372036854775808");
  EXPECT_EQ(Rational(smallest) + Rational(largest), Rational(-1));
  EXPECT_EQ((-Rational(smallest)).to_string(), "9223372036854775808");
}

TEST(Rational, AFailedDivisionChangesNothing) {
  Rational x(3, 7);
  EXPECT_THROW(x /= Rational(0), std::domain_error);
  EXPECT_EQ(x, Rational(3, 7));
  EXPECT_THROW(Rational(1, 0), std::domain_error);
}

TEST(Rational, PowersBinomialsAndFactorialsFollowTheirRecurrences) {
  for (long n = -200; n < 200; ++n) {
    EXPECT_EQ(Rational::power_of_two(n + 1), Rational(2) * Rational::power_of_two(n));
  }
  EXPECT_EQ(Rational::power_of_two(0), Rational(1));
  EXPECT_EQ(Rational::factorial(0), Rational(1));
  for (unsigned long n = 1; n < 60; ++n) {
    EXPECT_EQ(Rational::factorial(n), Rational(static_cast<long>(n)) * Rational::factorial(n - 1));
    EXPECT_EQ(Rational::binomial(n, 0), Rational(1));
    for (unsigned long k = 1; k <= n; ++k) {
      EXPECT_EQ(Rational::binomial(n, k),
                Rational::binomial(n - 1, k - 1) + Rational::binomial(n - 1, k));
    }
  }
}

TEST(Rational, ReadsDecimals) {
  RandomNumbers random;
  for (int i = 0; i < random_cases; ++i) {
    const long digits = random.whole(), exponent = random.integer(-40, 40);
    Rational scaled(digits);
    for (long k = 0; k < exponent; ++k) scaled *= Rational(10);
    for (long k = 0; k > exponent; --k) scaled /= Rational(10);
    const std::string text = std::to_string(digits) + "e" + std::to_string(exponent);
    ASSERT_EQ(Rational::from_decimal(text), scaled) << text;
  }
  EXPECT_EQ(Rational::from_decimal("-0.250"), Rational(-1, 4));
  EXPECT_EQ(Rational::from_decimal("+.5E+1"), Rational(5));
  EXPECT_EQ(Rational::from_decimal("-0"), Rational(0));
}

TEST(Rational, RefusesWhatIsNoDecimal) {
  for (const char* text : {"", "-", ".", "+-1", "1.2.3", "1e", "1e+", "1e+-5", "1e--5", "0x1", "1 ",
                           " 1", "inf", "nan", "1e10001", "1e-10001", "1e99999999999999999999"}) {
    EXPECT_THROW(Rational::from_decimal(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace wavecurve::certified
