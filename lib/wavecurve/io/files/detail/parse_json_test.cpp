#include "wavecurve/io/files/detail/parse_json.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

namespace wavecurve::io {
namespace {

using nlohmann::json;

std::string refusal(const std::string& text) {
  try {
    parse_json(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ParseJson, ReadsEveryKindOfValue) {
  const std::string text =
      R"({"a": [null, true, false, -3, 18446744073709551615, 2.50, "\u00e9\n"], "": {}, "b": []})";
  const json document = parse_json(text);
  EXPECT_EQ(document, json::parse(text));
  EXPECT_EQ(document["a"][5], 2.5);
  EXPECT_EQ(parse_json("3"), 3);
  EXPECT_EQ(parse_json(text, JsonNumbers::as_written)["a"][5], "2.50");
  EXPECT_EQ(parse_json(text, JsonNumbers::as_written)["a"][3], -3);
  EXPECT_EQ(parse_ordered_json(R"({"b": 1, "a": 2})").dump(), R"({"b":1,"a":2})");
}

TEST(ParseJson, SaysWhereItIsBroken) {
  EXPECT_EQ(refusal(""), "not JSON: it is empty");
  EXPECT_EQ(refusal("[1,\n 2,\n x]"), "not JSON: line 3, column 2: 'x' is not expected");
  EXPECT_EQ(refusal("[1] 2"), "not JSON: line 1, column 5: '2' is not expected");
  EXPECT_EQ(refusal("-1e999"), "not JSON: line 1, column 6: '-1e999' is too large a number");
  EXPECT_EQ(refusal(R"({"a": 1, "b": {"a": 2}, "a": 3})"), "key 'a' stands twice");
}

TEST(ParseJson, BoundsTheDepth) {
  const auto lists = [](std::size_t deep) {
    return std::string(deep, '[') + std::string(deep, ']');
  };
  EXPECT_EQ(refusal(lists(deepest_json)), "");
  EXPECT_EQ(refusal(lists(deepest_json + 1)), "the document is nested more than 100 deep");
  EXPECT_EQ(refusal(std::string(1000000, '[')), "the document is nested more than 100 deep");
}

RC_GTEST_PROP(ParseJson, AnyTextIsReadAsTheLibraryReadsItOrRefusedInOneLine, ()) {
  std::string text;
  const std::vector<std::string> parts{"{", "}", "[",   "]",  ",", ":",    "\"a\"", "1",
                                       "-", ".", "1e9", "\n", " ", "true", "\"",    "\xff"};
  for (int i = *rc::gen::inRange(0, 12); i > 0; --i) text += *rc::gen::elementOf(parts);
  const json expected = json::parse(text, nullptr, false);
  const std::string message = refusal(text);
  RC_ASSERT(message.find('\n') == std::string::npos);
  if (message.empty()) {
    RC_ASSERT(parse_json(text) == expected);
  } else {
    RC_ASSERT(expected.is_discarded() || message == "key 'a' stands twice");
  }
}

}  // namespace
}  // namespace wavecurve::io
