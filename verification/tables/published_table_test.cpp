#include "verification/tables/published_table.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "verification/suite/data_folder.hpp"

namespace wavecurve::verification {
namespace {

const std::string header = "filter,quantity,index,printed\n";

/// The message of the refusal; empty if the table was taken.
std::string refusal(const std::string& text) {
  try {
    parse_published_table(text, "t.csv");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(PublishedTable, ReadsTheTablesOfThePublication) {
  for (const auto& [name, rows] : {std::pair{"table_1.csv", 24}, {"table_2.csv", 36}}) {
    const auto table = read_published_table(data_folder() / "published" / name);
    EXPECT_EQ(table.entries.size(), static_cast<std::size_t>(rows));
    EXPECT_TRUE(table.title.starts_with("Table ")) << table.title;
    EXPECT_FALSE(table.source.empty());
  }
}

TEST(PublishedTable, KeepsThePrintAndTheLine) {
  const auto table = parse_published_table("# title: T\n" + header + "\nD8,mu/mu0,-1,-.50\n", "f");
  ASSERT_EQ(table.entries.size(), 1U);
  const PublishedEntry& entry = table.entries[0];
  EXPECT_EQ(table.title, "T");
  EXPECT_EQ(entry.line, 4);
  EXPECT_EQ(entry.filter, "D8");
  EXPECT_EQ(entry.quantity, Quantity::mu_normalized);
  EXPECT_EQ(entry.index, -1);
  EXPECT_EQ(entry.printed, "-.50");
  EXPECT_EQ(entry.number.decimals(), 2);
  EXPECT_EQ(table.location(entry), "f:4: ");
}

TEST(PublishedTable, KnowsEveryQuantityByItsName) {
  for (const char* name : {"h", "h*sqrt2", "h/sqrt2", "alpha", "mu", "nu", "mu/mu0", "nu/nu0"}) {
    const auto table = parse_published_table(header + "db4," + name + ",0,1\n", "f");
    EXPECT_EQ(to_string(table.entries[0].quantity), name);
  }
}

TEST(PublishedTable, TakesWhatSpreadsheetsWrite) {
  const auto plain = parse_published_table(header + "D8,h,0,0.25\n", "f");
  for (const std::string& text :
       {std::string("\xEF\xBB\xBF"
                    "filter,quantity,index,printed\r\nD8,h,0,0.25\r\n"),
        std::string("filter,quantity,index,printed\nD8,h,0,0.25"),
        std::string("printed,index,quantity,filter\n0.25,0,h,D8\n"),
        std::string(" filter , quantity , index , printed \n D8 ,\th , 0 , 0.25 \n\n"),
        std::string("\"filter\",\"quantity\",index,printed\n\"D8\",\"h\",\"0\",\"0.25\"\n")}) {
    const auto table = parse_published_table(text, "f");
    ASSERT_EQ(table.entries.size(), 1U) << text;
    EXPECT_EQ(table.entries[0].filter, plain.entries[0].filter) << text;
    EXPECT_EQ(table.entries[0].number, plain.entries[0].number) << text;
  }
  const auto quoted = parse_published_table(header + "\"a \"\"b\"\", c\",h,0,1\n", "f");
  EXPECT_EQ(quoted.entries[0].filter, "a \"b\", c");
}

TEST(PublishedTable, NamesFileLineAndFaultOfAMalformedTable) {
  const std::string row = "D8,h,0,0.25\n";
  EXPECT_TRUE(refusal("").starts_with("t.csv:1: the table is empty"));
  EXPECT_TRUE(refusal("# only a comment\n").starts_with("t.csv:1: the table is empty"));
  EXPECT_TRUE(refusal(header).starts_with("t.csv:1: the table has a header and no rows"));
  EXPECT_TRUE(refusal("filter,quantity,printed\nD8,h,0\n")
                  .starts_with("t.csv:1: the header has no column 'index'"));
  EXPECT_TRUE(refusal("filter,quantity,index,index,printed\n")
                  .starts_with("t.csv:1: the header has column 'index' twice"));
  EXPECT_TRUE(refusal("filter,index,printed\n"
                      "D8,0,1\n")
                  .starts_with("t.csv:2: the header has no column 'quantity'"));
  EXPECT_TRUE(refusal("quantity,index,printed\n"
                      "h,0,1\n")
                  .starts_with("t.csv:2: the header has no column 'filter'"));
  EXPECT_TRUE(refusal(row).starts_with("t.csv:1: the header has no column"));
  EXPECT_TRUE(refusal(header + row + "D8,h,1\n").starts_with("t.csv:3: the row has 3 fields"));
  EXPECT_TRUE(refusal(header + "D8,q,0,0.25\n").starts_with("t.csv:2: the quantity 'q' is not"));
  EXPECT_TRUE(
      refusal(header + "D8,h,x,0.25\n").starts_with("t.csv:2: the index 'x' is not an integer"));
  EXPECT_TRUE(refusal(header + "D8,h,1.7,0.25\n").starts_with("t.csv:2: the index '1.7' is not"));
  EXPECT_TRUE(refusal(header + "D8,h,99999999999999,0.25\n").starts_with("t.csv:2: the index"));
  EXPECT_TRUE(
      refusal(header + "D8,h,0,abc\n").starts_with("t.csv:2: 'abc' is not a decimal number"));
  EXPECT_TRUE(refusal(header + "D8,h,0,\n").starts_with("t.csv:2: '' is not a decimal number"));
  EXPECT_TRUE(refusal(header + ",h,0,1\n").starts_with("t.csv:2: the filter's name is missing"));
  EXPECT_TRUE(
      refusal(header + "\"D8,h,0,1\n").starts_with("t.csv:2: a quoted field is not closed"));
  EXPECT_TRUE(
      refusal(header + "\"D8\"x,h,0,1\n").starts_with("t.csv:2: text follows a closing quote"));
  EXPECT_TRUE(refusal(header + row + "\n" + row).starts_with("t.csv:4: the row repeats line 2"));
  EXPECT_TRUE(refusal(header + std::string("D8,h\0,0,1\n", 10))
                  .starts_with("t.csv:2: the line has control characters"));
  EXPECT_TRUE(refusal("\x7f"
                      "ELF\x02\x01\n")
                  .starts_with("t.csv:1: the line has control characters"));
}

TEST(PublishedTable, TakesDefaultsFromComments) {
  const auto table = parse_published_table(
      "# Filter: db4\n #quantity : h\nindex,printed\n0,0.25\n# filter: db5\n"
      "# quantity: alpha\n0,2\n",
      "f");
  ASSERT_EQ(table.entries.size(), 2U);
  EXPECT_EQ(table.entries[0].filter, "db4");
  EXPECT_EQ(table.entries[0].quantity, Quantity::taps);
  EXPECT_EQ(table.entries[1].filter, "db5");
  EXPECT_EQ(table.entries[1].quantity, Quantity::autocorrelation);
  const auto filled =
      parse_published_table("# filter: db4\n# quantity: mu\n" + header + "D8,h,0,1\n,,0,1\n", "f");
  EXPECT_EQ(filled.entries[0].filter, "D8");
  EXPECT_EQ(filled.entries[1].filter, "db4");
  EXPECT_EQ(filled.entries[1].quantity, Quantity::mu);
  EXPECT_TRUE(
      refusal("# quantity: x\n").starts_with("t.csv:1: the quantity 'x' is not understood"));
  EXPECT_TRUE(refusal("# filter:\n").starts_with("t.csv:1: the filter's name is missing"));
}

TEST(PublishedTable, KeepsExtraColumns) {
  const auto table = parse_published_table(
      "page,filter,quantity,index,printed,\"a note\"\n12,D8,h,0,0.25,\"x, y\"\n", "f");
  EXPECT_EQ(table.extra_columns, (std::vector<std::string>{"page", "a note"}));
  EXPECT_EQ(table.entries[0].extra, (std::vector<std::string>{"12", "x, y"}));
  EXPECT_EQ(table.entries[0].filter, "D8");
}

TEST(PublishedTable, TakesSemicolonsAndTabsAndThenDecimalCommas) {
  for (const std::string separator : {";", "\t"}) {
    std::string text = "# filter: D8\n# quantity: h\nindex,value\n0|0,25\n1|-1,5e-3\n2|3\n";
    for (std::string::size_type i; (i = text.find('|')) != std::string::npos;) {
      text.replace(i, 1, separator);
    }
    text.replace(text.find("index,"), 6, "index" + separator);
    const auto table = parse_published_table(text, "f");
    ASSERT_EQ(table.entries.size(), 3U);
    EXPECT_EQ(table.entries[0].number.text(), "0.25");
    EXPECT_EQ(table.entries[0].printed, "0,25");
    EXPECT_EQ(table.entries[1].number.text(), "-1.5e-3");
  }
  const std::string german = "filter;quantity;index;printed\nD8;h;0;0,25\n";
  EXPECT_TRUE(refusal(german + "D8;h;1;0.5\n").starts_with("t.csv:3: '0.5' has a decimal point"));
  EXPECT_TRUE(refusal(german + "D8;h;1;1.234,5\n").starts_with("t.csv:3: '1.234,5' "));
  EXPECT_TRUE(refusal(header + "D8,h,0,\"0,25\"\n").starts_with("t.csv:2: '0,25' is not"));
}

TEST(PublishedTable, TakesLineEndsAndEncodingsOfEverySystem) {
  const std::string text = header + "D8,h,0,0.25\nD8,h,1,\u22120.5\n";
  std::string cr = text, crlf, utf16;
  for (char& c : cr) c = c == '\n' ? '\r' : c;
  for (const char c : text) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  for (const char c : header + "D8,h,0,0.25\r\nD8,h,1,-0.5") {
    utf16 += c;
    utf16 += '\0';
  }
  for (const std::string& form : {text, cr, crlf, utf16, "\xFF\xFE" + utf16}) {
    const auto table = parse_published_table(form, "f");
    ASSERT_EQ(table.entries.size(), 2U);
    EXPECT_EQ(table.entries[1].line, 3);
    EXPECT_EQ(table.entries[1].number.text(), "-0.5");
  }
  EXPECT_TRUE(refusal(utf16 + "x").starts_with("t.csv:1: the line has control characters"));
  EXPECT_TRUE(
      refusal("\xFF\xFE" + utf16 + "x").starts_with("t.csv:1: the text is no whole UTF-16"));
}

TEST(PublishedTable, BoundsTheIndex) {
  const auto table =
      parse_published_table(header + "D8,h,-1000000000,1\nD8,h,\u22123,1\nD8,h,+0004,1\n", "f");
  EXPECT_EQ(table.entries[0].index, -1000000000);
  EXPECT_EQ(table.entries[1].index, -3);
  EXPECT_EQ(table.entries[2].index, 4);
  for (const std::string index : {"-2147483648", "2147483647", "1000000001", "-9999999999999999"}) {
    EXPECT_TRUE(refusal(header + "D8,h," + index + ",1\n")
                    .starts_with("t.csv:2: the index '" + index + "' is out of range"));
  }
  for (const std::string index : {"", "+-3", "0x1", "- 3", "3.7"}) {
    EXPECT_NE(refusal(header + "D8,h," + index + ",1\n").find("' is not a"), std::string::npos)
        << index;
  }
}

TEST(PublishedTable, BoundsTheRows) {
  std::string text = "# filter: D8\n# quantity: h\nindex,printed\n";
  for (int i = 0; i <= most_rows; ++i) text += std::to_string(i) + ",1\n";
  EXPECT_TRUE(refusal(text).ends_with("the table has more than 500000 rows"));
}

TEST(PublishedTable, RefusesAFileWithoutEnd) {
  if (!std::filesystem::exists("/dev/zero")) GTEST_SKIP() << "no /dev/zero here";
  try {
    read_published_table("/dev/zero");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "cannot read /dev/zero: it is larger than 67108864 bytes");
  }
}

/// Whatever the bytes: a table whose entries are whole, or one short line without control characters.
void expect_table_or_refusal(const std::string& text) {
  try {
    const PublishedTable table = parse_published_table(text, "t.csv");
    RC_ASSERT(!table.entries.empty());
    for (const PublishedEntry& entry : table.entries) {
      RC_ASSERT(entry.extra.size() == table.extra_columns.size());
      RC_ASSERT(entry.line > 0 && !entry.filter.empty());
      RC_ASSERT(parse_printed_number(entry.number.text()) == entry.number);
    }
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    RC_ASSERT(message.starts_with("t.csv:"));
    RC_ASSERT(message.size() < 300U);
    RC_ASSERT(std::none_of(message.begin(), message.end(),
                           [](unsigned char c) { return c < ' ' || c == 0x7f; }));
  }
}

RC_GTEST_PROP(PublishedTable, EveryByteStringIsATableOrARefusal, ()) {
  expect_table_or_refusal(*rc::gen::string<std::string>());
  const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "filter,quantity,index,printed\n", "index;value\n", "# filter: db4\n", "# quantity: h\n",
      "D8,h,0,0.25\n", "D8,h,1,-1e-3\n", "0;0,5\n", "1;2\n", ",", ";", "\t", "\"", "\r", "\n", "#",
      ":", "\xEF\xBB\xBF", "\xFF\xFE", "\xFE\xFF", std::string(1, '\0'), "-2147483648", "1/0",
      "\x1B[31m", "\xE2\x88\x92", std::string(2000, 'x'), std::string(300, ',')));
  std::string text;
  for (const std::string& piece : pieces) text += piece;
  expect_table_or_refusal(text);
}

/// A right table with some bytes replaced.
RC_GTEST_PROP(PublishedTable, AMutatedTableIsATableOrARefusal, ()) {
  std::string text = "# title: t\n# filter: db4\n" + header +
                     "D8,h,0,0.25\n,mu,-1,75/64\n\"D8\",h,2,5.3*10^-3\n,nu,1,0.123 456\n";
  const int edits = *rc::gen::inRange(1, 6);
  for (int i = 0; i < edits; ++i) {
    const auto place = *rc::gen::inRange<std::size_t>(0, text.size());
    text[place] = static_cast<char>(*rc::gen::inRange(0, 256));
  }
  expect_table_or_refusal(text);
}

TEST(PublishedTable, DoesNotRepeatARowOfAMillionCharacters) {
  for (const std::string& text :
       {header + "D8,h,0," + std::string(1000000, '1') + "\n", std::string(1000000, ','),
        header + std::string(1000000, 'x') + ",h,0,1\n",
        header + "D8," + std::string(5000, 'q') + ",0,1\n",
        header + "D8,h," + std::string(5000, '1') + ",1\n",
        header + "D8,h,0," + std::string(5000, '1') + "\n"}) {
    const std::string message = refusal(text);
    EXPECT_TRUE(message.starts_with("t.csv:")) << message;
    EXPECT_LT(message.size(), 200U);
  }
}

TEST(PublishedTable, RefusesAFileThatIsNotThere) {
  EXPECT_THROW(read_published_table("no/such/table.csv"), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::verification
