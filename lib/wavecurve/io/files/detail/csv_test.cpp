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

TEST(Csv, NoSpreadsheetTakesATextForAFormula) {
  for (const char* text : {"=1+1", "@sum", "-1-1", "+cmd|x", "'=1", "''-x"}) {
    const std::string field = csv_field(text);
    EXPECT_EQ(field, "'" + std::string(text));
    EXPECT_EQ(csv_fields(field), Fields{text});
  }
  for (const char* number : {"-0.5", "+1.5e-7", "-3"}) EXPECT_EQ(csv_field(number), number);
  EXPECT_EQ(csv_field("=a,b"), "\"'=a,b\"");
  EXPECT_EQ(csv_fields("'a,'"), (Fields{"'a", "'"}));
}

TEST(Csv, WhatIsNoTextIsReplaced) {
  EXPECT_EQ(csv_field("a\x1b[2J\xff"), "a\uFFFD[2J\uFFFD");
  EXPECT_EQ(csv_field("a\nb"), "\"a\nb\"");
}

RC_GTEST_PROP(Csv, WhatIsWrittenIsRead, ()) {
  const auto character = rc::gen::elementOf(
      std::vector<std::string>{"a", "=", "-", "'", "\"", ",", ";", " ", "\t", "1", "e", "\u00e9"});
  const auto text = rc::gen::map(rc::gen::container<std::vector<std::string>>(character),
                                 [](const std::vector<std::string>& parts) {
                                   std::string whole;
                                   for (const std::string& part : parts) whole += part;
                                   return whole;
                                 });
  const auto texts = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::string>>(text));
  std::string line;
  for (const std::string& one : texts) line += (&one == &texts[0] ? "" : ",") + csv_field(one);
  RC_ASSERT(csv_fields(line) == texts);
}

}  // namespace
}  // namespace wavecurve::io
