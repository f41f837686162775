#include "verification/tables/published_table.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

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
  EXPECT_TRUE(refusal("filter,quantity,index,printed,note\n")
                  .starts_with("t.csv:1: the header has 5 columns"));
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
