#include "verification/tables/table_columns.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

TEST(TableColumns, KnowsTheSeparatorByTheNames) {
  EXPECT_EQ(parse_table_columns("filter,quantity,index,printed").separator, ',');
  EXPECT_EQ(parse_table_columns("index;printed").separator, ';');
  EXPECT_EQ(parse_table_columns("index\tprinted").separator, '\t');
  EXPECT_EQ(parse_table_columns("index;printed;a note, with commas, of its own").separator, ';');
}

TEST(TableColumns, TakesNamesInAnyCaseAndOrder) {
  const TableColumns columns = parse_table_columns("Printed , \"note\",INDEX,Filter");
  EXPECT_EQ(columns.printed, 0U);
  EXPECT_EQ(columns.index, 2U);
  EXPECT_EQ(columns.filter, 3U);
  EXPECT_FALSE(columns.quantity);
  EXPECT_EQ(columns.extra_names, (std::vector<std::string>{"note"}));
}

TEST(TableColumns, TakesValueForPrintedUnlessBothAreThere) {
  EXPECT_EQ(parse_table_columns("index,Value").printed, 1U);
  const TableColumns both = parse_table_columns("value,index,printed");
  EXPECT_EQ(both.printed, 2U);
  EXPECT_EQ(both.extra_names, (std::vector<std::string>{"value"}));
}

TEST(TableColumns, NamesEveryExtraColumnDifferently) {
  const TableColumns columns = parse_table_columns("note,index,note,printed,,note,,");
  EXPECT_EQ(columns.count, 6U) << "empty names at the end are no columns";
  EXPECT_EQ(columns.extra_names,
            (std::vector<std::string>{"note", "note (2)", "column 5", "note (3)"}));
}

TEST(TableColumns, GivesARowAsManyFieldsAsTheHeader) {
  const TableColumns columns = parse_table_columns("index;printed");
  EXPECT_EQ(parse_table_row("0;\"1;5\"", columns), (std::vector<std::string>{"0", "1;5"}));
  EXPECT_EQ(parse_table_row("0;0.5;; ", columns).size(), 2U);
  EXPECT_THROW(parse_table_row("0", columns), std::invalid_argument);
  EXPECT_THROW(parse_table_row("0;1;2", columns), std::invalid_argument);
}

TEST(TableColumns, RefusesTooManyColumns) {
  EXPECT_THROW(parse_table_columns("index,printed" + std::string(63, ',') + "x"),
               std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::verification
