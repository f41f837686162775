#include "verification/prints/misprint.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::verification {
namespace {

std::optional<Repair> repair(const std::string& print, const std::string& right) {
  const std::vector<PrintedNumber> candidates{parse_printed_number(right)};
  return likeliest_repair(parse_printed_number(print), candidates);
}

void expect_edit(const std::string& print, const std::string& right, Edit edit) {
  const auto found = repair(print, right);
  ASSERT_TRUE(found) << print << " " << right;
  EXPECT_EQ(found->edit, edit) << print << " " << right << ": " << found->description;
  EXPECT_EQ(found->repaired, parse_printed_number(right));
}

TEST(Misprint, FindsEachKindOfEdit) {
  const std::string right = "-0.634202334430";
  expect_edit("0.634202334430", right, Edit::sign);
  expect_edit("-0.63420233430", right, Edit::dropped_digit);
  expect_edit("-0.6342302334430", right, Edit::added_digit);
  expect_edit("-0.634203234430", right, Edit::swapped_digits);
  expect_edit("-0.634802334430", right, Edit::wrong_digit);
  expect_edit("-6.34202334430", right, Edit::moved_point);
  expect_edit("-634202334430", right, Edit::moved_point);
  expect_edit("-0.334202364430", right, Edit::swapped_apart);
}

TEST(Misprint, ReadsALackingZeroAsADroppedDigit) {
  expect_edit("-0.00000001267", "-0.000000001267", Edit::dropped_digit);
  EXPECT_EQ(repair("-0.00000001267", "-0.000000001267")->description,
            "a dropped 0 (of those behind the point)");
  expect_edit("0.00000000013", "0.000000000013", Edit::dropped_digit);
}

TEST(Misprint, FindsEditsOfScientificPrints) {
  expect_edit("1.893e-6", "1.893e-7", Edit::moved_point);
  expect_edit("1.893e6", "1.893e-6", Edit::moved_point);
  expect_edit("1.983e-6", "1.893e-6", Edit::swapped_digits);
  EXPECT_FALSE(repair("1.893e-6", "1.893e-17"));
}

TEST(Misprint, NeverCallsOneUnitAMisprint) {
  EXPECT_FALSE(repair("0.634202334431", "0.634202334430"));
  EXPECT_FALSE(repair("0.634202334429", "0.634202334430"));
  EXPECT_FALSE(repair("0.1234999", "0.1235000"));
  EXPECT_FALSE(
      repair("0.28204770197", "0.282047701976"));  // cut off, or a digit dropped at the end
}

TEST(Misprint, NeedsMoreThanOneEditToStayAway) {
  EXPECT_FALSE(repair("-0.039535740096", "-0.039535740112"));
  EXPECT_FALSE(repair("0.634202334430", "-0.634802334430"));
  EXPECT_FALSE(repair("0.634202334430", "0.634202334430"));
}

TEST(Misprint, TakesTwoWrongDigitsForNoSwap) {
  EXPECT_FALSE(repair("0.128856", "0.123456"));
  EXPECT_FALSE(repair("0.213459", "0.123456")) << "a swap and a wrong digit";
  EXPECT_FALSE(repair("1.983e-5", "1.893e-7")) << "a swap and a wrong exponent";
}

TEST(Misprint, SwapsNeighboursAcrossThePoint) {
  expect_edit("2.1345678", "1.2345678", Edit::swapped_digits);
}

TEST(Misprint, ReadsLeadingZerosAsNoDigits) {
  expect_edit("01.2345678", "1.2345978", Edit::wrong_digit);
}

TEST(Misprint, DistrustsRepairsOfVeryShortPrints) {
  EXPECT_FALSE(repair("0.7", "0.2"));
  EXPECT_FALSE(repair("0.27", "0.23"));
  EXPECT_FALSE(repair("0.3", "-0.3"));
  EXPECT_FALSE(repair("0.321", "0.123")) << "one digit of three is left";
  EXPECT_FALSE(repair("0.00", "0.07"));
  EXPECT_TRUE(repair("0.23", "-0.23"));
}

TEST(Misprint, SaysWhenOnlyTheLastDigitIsWrong) {
  EXPECT_TRUE(repair("-0.029320137980", "-0.029320137983")->only_last_digit);
  EXPECT_FALSE(repair("-0.029320137083", "-0.029320137983")->only_last_digit);
}

TEST(Misprint, PrefersTheFirstCandidate) {
  const std::vector<PrintedNumber> both{parse_printed_number("0.124356"),
                                        parse_printed_number("0.12456")};
  EXPECT_EQ(likeliest_repair(parse_printed_number("0.123456"), both)->edit, Edit::swapped_digits);
  const std::vector<PrintedNumber> turned{both[1], both[0]};
  EXPECT_EQ(likeliest_repair(parse_printed_number("0.123456"), turned)->edit, Edit::added_digit);
}

TEST(Misprint, IsRuledOutByAnyCandidateOneUnitAway) {
  const std::vector<PrintedNumber> candidates{parse_printed_number("0.12346678"),
                                              parse_printed_number("0.12345679")};
  EXPECT_EQ(likeliest_repair(parse_printed_number("0.12345678"), candidates), std::nullopt);
}

// --- properties: any single edit of a right number is found and undone ---

std::string random_print() {
  const int digits = *rc::gen::inRange(6, 16);
  std::string text = *rc::gen::arbitrary<bool>() ? "-" : "";
  text += static_cast<char>('0' + *rc::gen::inRange(0, 3));
  text += '.';
  for (int i = 0; i < digits; ++i) text += static_cast<char>('0' + *rc::gen::inRange(0, 10));
  return text;
}

std::size_t random_digit_place(const std::string& text) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] >= '0' && text[i] <= '9') places.push_back(i);
  }
  return places[*rc::gen::inRange<std::size_t>(0, places.size())];
}

std::string edited(std::string text, Edit edit) {
  const std::size_t place = random_digit_place(text), other = random_digit_place(text);
  const char digit = static_cast<char>('0' + *rc::gen::inRange(0, 10));
  switch (edit) {
    case Edit::sign:
      return text.starts_with('-') ? text.substr(1) : "-" + text;
    case Edit::dropped_digit:
      return text.erase(place, 1);
    case Edit::added_digit:
      return text.insert(place, 1, digit);
    case Edit::wrong_digit:
      text[place] = digit;
      return text;
    case Edit::moved_point: {
      const std::size_t point = text.find('.');
      text.erase(point, 1);
      return text.insert(point + *rc::gen::inRange<std::size_t>(1, 4), ".");
    }
    default:
      std::swap(text[place], text[other]);
      return text;
  }
}

RC_GTEST_PROP(Misprint, EverySingleEditIsUndone, ()) {
  const std::string right = random_print();
  const Edit edit = *rc::gen::element(Edit::sign, Edit::dropped_digit, Edit::added_digit,
                                      Edit::wrong_digit, Edit::moved_point, Edit::swapped_apart);
  const std::string print = edited(right, edit);
  const PrintedNumber wrong = parse_printed_number(print), target = parse_printed_number(right);
  RC_PRE(wrong.value() != target.value());
  RC_PRE(print.find_first_of("0123456789") <
         print.find('.'));  // "0" dropped before the point: ".5"
  const auto found = find_repair(wrong, target);
  RC_ASSERT(found.has_value());
  RC_ASSERT(found->repaired.value() == target.value());
}

RC_GTEST_PROP(Misprint, OneUnitIsNeverAMisprint, (bool up)) {
  const PrintedNumber right = parse_printed_number(random_print());
  const certified::Rational shifted =
      up ? right.value() + right.unit() : right.value() - right.unit();
  PrintedNumber neighbour = right;
  std::size_t i = neighbour.digits.size();
  const bool grows = up != right.negative;
  while (i-- > 0) {
    char& digit = neighbour.digits[i];
    if (grows && digit < '9') {
      ++digit;
      break;
    }
    if (!grows && digit > '0') {
      --digit;
      break;
    }
    digit = grows ? '0' : '9';
  }
  RC_PRE(neighbour.value() == shifted);
  const std::vector<PrintedNumber> candidates{right};
  RC_ASSERT(!likeliest_repair(neighbour, candidates));
}

}  // namespace
}  // namespace wavecurve::verification
