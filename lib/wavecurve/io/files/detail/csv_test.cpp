#include "wavecurve/io/files/detail/csv.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::io {
namespace {

using Fields = std::vector<std::string>;

TEST(Csv, FieldsAreTrimmedAndMayBeEmpty) {
  EXPECT_EQ(csv_fields("a, b\t,c d"), (Fields{"a", "b", "c d"}));
  EXPECT_EQ(csv_fields(",,"), (Fields{"", "", ""}));
  EXPECT_EQ(csv_fields(""), Fields{""});
  EXPECT_EQ(csv_fields("a\t\tb", '\t'), (Fields{"a", "", "b"}));
  EXPECT_EQ(csv_fields("1;2,5", ';'), (Fields{"1", "2,5"}));
}

TEST(Csv, QuotesKeepWhatIsInside) {
  EXPECT_EQ(csv_fields(R"("a, b" , "say ""no""",c)"), (Fields{"a, b", "say \"no\"", "c"}));
  EXPECT_EQ(csv_fields(R"("","  ","""")"), (Fields{"", "  ", "\""}));
  EXPECT_EQ(csv_fields(R"(5" tall,x)"), (Fields{"5\" tall", "x"}));
}

TEST(Csv, BadQuotesAreRefused) {
  EXPECT_THROW(csv_fields("\"a,b"), std::invalid_argument);
  EXPECT_THROW(csv_fields("\"a\"b,c"), std::invalid_argument);
}

TEST(Csv, OnlyWhatNeedsQuotesHasThem) {
  EXPECT_EQ(csv_field("db4"), "db4");
  EXPECT_EQ(csv_field("a,\"b\""), "\"a,\"\"b\"\"\"");
  EXPECT_EQ(csv_field(" a"), "\" a\"");
}

RC_GTEST_PROP(Csv, WhatIsWrittenIsRead, (const std::vector<std::string>& texts)) {
  RC_PRE(!texts.empty());
  std::string line;
  for (const std::string& text : texts) line += (&text == &texts[0] ? "" : ",") + csv_field(text);
  RC_ASSERT(csv_fields(line) == texts);
}

}  // namespace
}  // namespace wavecurve::io
