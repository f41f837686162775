#include "wavecurve/filters/detail/characters.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace wavecurve {
namespace {

const std::string gone(replacement_character);

/// The encoding by its definition.
std::string encoded(char32_t code) {
  const auto byte = [](char32_t value) { return static_cast<char>(value); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | code >> 6), byte(0x80 | (code & 0x3F))};
  if (code < 0x10000) {
    return {byte(0xE0 | code >> 12), byte(0x80 | (code >> 6 & 0x3F)), byte(0x80 | (code & 0x3F))};
  }
  return {byte(0xF0 | code >> 18), byte(0x80 | (code >> 12 & 0x3F)),
          byte(0x80 | (code >> 6 & 0x3F)), byte(0x80 | (code & 0x3F))};
}

TEST(Characters, EveryCharacterOfUnicodeIsTakenWholeAndASurrogateIsNone) {
  for (char32_t code = 0; code <= 0x10FFFF; ++code) {
    const std::string bytes = encoded(code) + "x";
    std::string_view rest = bytes;
    const Character character = take_character(rest);
    const bool is_surrogate = code >= 0xD800 && code < 0xE000;
    ASSERT_EQ(character.is_valid(), !is_surrogate) << static_cast<unsigned>(code);
    if (is_surrogate) continue;
    ASSERT_EQ(character.code, code);
    ASSERT_EQ(rest, "x") << static_cast<unsigned>(code);
  }
}

TEST(Characters, WhatIsNoUtf8IsTakenByteByByte) {
  // A byte that only continues, one that begins nothing, overlong forms, a surrogate, beyond the
  // last, and characters that end too early.
  for (const char* bytes :
       {"\x80", "\xFF", "\xC0\x80", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80",
        "\xF8\x88\x80\x80", "\xC3", "\xE2\x82", "\xF0\x9F\x98"}) {
    const std::string_view text = bytes;
    std::string expected;
    for (std::size_t i = 0; i < text.size(); ++i) expected += gone;
    EXPECT_EQ(printable(text), expected) << text.size();
  }
  EXPECT_EQ(printable("a\xC3z\xC3\xA9"), "a" + gone + "z\xC3\xA9");
}

TEST(Characters, WhatATerminalObeysIsNotPrinted) {
  EXPECT_EQ(printable("db4 \xCE\xBC \xE2\x88\x92"), "db4 \xCE\xBC \xE2\x88\x92");
  for (const char* control : {"\x1b", "\r", "\n", "\t", "\b", "\x7f", "\xC2\x9B", "\xE2\x80\xAE",
                              "\xE2\x80\xA8", "\xE2\x81\xA6"}) {
    EXPECT_EQ(printable("a" + std::string(control) + "b"), "a" + gone + "b");
  }
  EXPECT_EQ(printable(std::string_view("\0", 1)), gone);
}

TEST(Characters, ALongTextIsCutBetweenCharacters) {
  EXPECT_EQ(printable("\xC3\xA9\xC3\xA9\xC3\xA9", 2), "\xC3\xA9\xC3\xA9...");
  EXPECT_EQ(printable("ab", 2), "ab");
}

}  // namespace
}  // namespace wavecurve
