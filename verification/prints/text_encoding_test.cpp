#include "verification/prints/text_encoding.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::verification {
namespace {

/// UTF-16 of a text, one unit a character of it.
std::string utf16(const std::u16string& text, bool little) {
  std::string bytes;
  for (const char16_t unit : text) {
    const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
    bytes += little ? low : high;
    bytes += little ? high : low;
  }
  return bytes;
}

TEST(TextEncoding, ReadsUtf16OfEitherByteOrder) {
  const std::u16string text = u"a,\u2212\u00B5\U0001D465\n";
  const std::string expected = "a,\u2212\u00B5\U0001D465\n";
  for (const bool little : {true, false}) {
    EXPECT_EQ(to_utf8(utf16(u"\uFEFF" + text, little)), expected) << little;
    EXPECT_EQ(to_utf8(utf16(u"index," + text, little)), "index," + expected) << little;
  }
}

TEST(TextEncoding, LeavesUtf8AsItIs) {
  EXPECT_EQ(to_utf8("\xEF\xBB\xBF"
                    "a\u2212"),
            "a\u2212");
  EXPECT_EQ(to_utf8("a\u2212"), "a\u2212");
  EXPECT_EQ(to_utf8(""), "");
  const std::string binary("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\1\0", 18);
  EXPECT_EQ(to_utf8(binary), binary);
}

TEST(TextEncoding, RefusesUtf16ThatBreaksOff) {
  using namespace std::string_literals;
  EXPECT_THROW(to_utf8("\xFF\xFE"
                       "a\0b"s),
               std::invalid_argument);
  EXPECT_THROW(to_utf8("\xFF\xFE\x35\xD8"s), std::invalid_argument) << "half of a pair";
  EXPECT_THROW(to_utf8("\xFF\xFE\x35\xD8"
                       "a\0"s),
               std::invalid_argument);
  EXPECT_THROW(to_utf8("\xFF\xFE\x65\xDC"s), std::invalid_argument) << "the second half";
  EXPECT_THROW(to_utf8("\xFF\xFE\0\0a\0\0\0"s), std::invalid_argument) << "UTF-32";
  EXPECT_THROW(to_utf8("\0\0\xFE\xFF\0\0\0a"s), std::invalid_argument);
}

RC_GTEST_PROP(TextEncoding, GoesThereAndBack, (std::vector<char16_t> units, bool little)) {
  std::u16string text(u"\uFEFF");
  std::string expected;
  for (const char16_t unit : units) {
    const auto ascii = static_cast<char16_t>(unit % 127 + 1);
    text += ascii;
    expected += static_cast<char>(ascii);
  }
  RC_ASSERT(to_utf8(utf16(text, little)) == expected);
}

TEST(TextLines, EndInAnyOfThreeWays) {
  std::vector<std::pair<std::string, int>> lines;
  for_each_text_line("a\nb\r\nc\r\rd\n\ne",
                     [&](std::string_view line, int number) { lines.emplace_back(line, number); });
  const std::vector<std::pair<std::string, int>> expected{{"a", 1}, {"b", 2}, {"c", 3}, {"", 4},
                                                          {"d", 5}, {"", 6},  {"e", 7}};
  EXPECT_EQ(lines, expected);
}

}  // namespace
}  // namespace wavecurve::verification
