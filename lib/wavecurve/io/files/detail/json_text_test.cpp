#include "wavecurve/io/files/detail/json_text.hpp"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

namespace wavecurve::io {
namespace {

using nlohmann::json;

TEST(JsonText, HoldsNothingThatATerminalObeys) {
  EXPECT_EQ(json_text(json("\x1b\x7f\xC2\x9B\xff\u00e9")), R"("\u001b\u007f\u009b)"
                                                           "\uFFFD\u00e9\"");
  EXPECT_EQ(json_text(json("\u202e\u2028")), R"("\u202e\u2028")");
  EXPECT_EQ(json_text(json{{"a", {1, 2.5}}}, 1), "{\n \"a\": [\n  1,\n  2.5\n ]\n}");
}

RC_GTEST_PROP(JsonText, AnyTextIsReadBackOrIsNoUtf8, (const std::string& text)) {
  const std::string written = json_text(json(text));
  const json read = json::parse(written);
  for (const char c : written) RC_ASSERT(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
  if (read.get<std::string>().find("\xEF\xBF\xBD") == std::string::npos) RC_ASSERT(read == text);
}

}  // namespace
}  // namespace wavecurve::io
