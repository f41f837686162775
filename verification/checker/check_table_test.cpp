#include "verification/checker/check_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "verification/prints/print_form.hpp"
#include "verification/prints/true_value.hpp"
#include "verification/quantities/filter_values.hpp"
#include "verification/suite/data_folder.hpp"

namespace wavecurve::verification {
namespace {

const std::string header = "filter,quantity,index,printed\n";

CheckedTable check(const std::string& rows) {
  return check_table(parse_published_table(header + rows, "t.csv"));
}

CheckedTable published(const std::string& name) {
  return check_table(read_published_table(data_folder() / "published" / name));
}

std::string refusal(const std::string& rows) {
  try {
    check(rows);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// Rows of the correctly rounded values.
std::string right_rows(const std::string& filter, const Quantity& quantity, int first, int last,
                       const PrintForm& form) {
  FilterValues values(find_table_filter(filter));
  std::string rows;
  for (int n = first; n <= last; ++n) {
    rows += filter + "," + std::string(to_string(quantity)) + "," + std::to_string(n) + "," +
            round_to_form(values.value(quantity, n), form)->text() + "\n";
  }
  return rows;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto place = text.find(from);
  if (place == std::string::npos) throw std::invalid_argument(from + " is not in the table");
  return text.replace(place, from.size(), to);
}

TEST(CheckTable, Table1IsCertifiedWhole) {
  const CheckedTable table = published("table_1.csv");
  EXPECT_EQ(table.counts(), (std::map<PrintVerdict, int>{{PrintVerdict::certified, 24}}));
  EXPECT_TRUE(table.is_right());
}

TEST(CheckTable, Table2CameByARoute) {
  const CheckedTable table = published("table_2.csv");
  EXPECT_EQ(table.counts(), (std::map<PrintVerdict, int>{{PrintVerdict::certified, 16},
                                                         {PrintVerdict::form, 2},
                                                         {PrintVerdict::misprint, 5},
                                                         {PrintVerdict::published_route, 13}}));
  EXPECT_FALSE(table.is_right());
  std::map<std::string, double> farthest;
  for (const CheckedRow& row : table.rows) {
    if (row.verdict != PrintVerdict::published_route) continue;
    double& most = farthest[to_string(row.entry.quantity)];
    most = std::max(most, row.ulps);
  }
  EXPECT_NEAR(farthest["alpha"], 8.1, 0.1);
  EXPECT_NEAR(farthest["mu/mu0"], 109, 1);
  EXPECT_NEAR(farthest["nu/nu0"], 139, 1);
  ASSERT_EQ(table.columns.size(), 3U);
  for (const CheckedColumn& column : table.columns) {
    EXPECT_EQ(column.matched, 12);
    EXPECT_EQ(column.of, 12);
    EXPECT_EQ(column.digits, 12);
  }
  for (const CheckedColumn& column : {table.columns[1], table.columns[2]}) {
    EXPECT_EQ(column.route, "alpha as printed; mu the eigenvector for the eigenvalue nearest zero");
  }
}

TEST(CheckTable, FindsTheRouteOfTable2WithoutItsAlphaColumn) {
  PublishedTable table = read_published_table(data_folder() / "published" / "table_2.csv");
  std::erase_if(table.entries, [](const PublishedEntry& entry) {
    return entry.quantity == Quantity::autocorrelation;
  });
  for (const CheckedColumn& column : check_table(table).columns) {
    EXPECT_EQ(column.matched, 12);
    EXPECT_NE(column.route.find("Daubechies 1992"), std::string::npos) << column.route;
    EXPECT_NE(column.route.find("eigenvalue nearest zero"), std::string::npos) << column.route;
  }
}

TEST(CheckTable, CertifiesCorrectRoundingsOfEveryQuantity) {
  for (const auto& [name, first] : {std::pair{"coif2", -4}, {"db4", 0}, {"bspline4.4", -2}}) {
    for (const Quantity& quantity :
         {Quantity::taps, Quantity::taps_sum_2, Quantity::taps_sum_1, Quantity::autocorrelation,
          Quantity::mu, Quantity::nu, Quantity::mu_normalized, Quantity::nu_normalized}) {
      for (const PrintForm& form : {PrintForm{false, 7}, {false, 40}, {true, 9}}) {
        const int from = is_taps(quantity) ? first : 1;
        const CheckedTable table = check(right_rows(name, quantity, from, from + 3, form));
        for (const CheckedRow& row : table.rows) {
          EXPECT_EQ(row.verdict, PrintVerdict::certified)
              << name << " " << to_string(quantity) << " " << row.entry.printed << row.detail;
          EXPECT_LE(row.ulps, 0.5);
        }
      }
    }
  }
}

TEST(CheckTable, JudgesATableWithErrors) {
  std::string rows = right_rows("sym6", Quantity::mu, 0, 8, {false, 10});
  const std::string right = rows;
  const CheckedTable clean = check(rows);
  const auto print = [&clean](int index) {
    return clean.rows[static_cast<std::size_t>(index)].entry.printed;
  };
  // index 1: digits 4 and 5 wrong beyond one edit; 2: sign lost; 3: one unit; 4: last digits cut
  // off; 5: nonsense
  std::string far = print(1);
  far[5] = far[5] == '9' ? '1' : static_cast<char>(far[5] + 1);
  far[7] = far[7] == '9' ? '1' : static_cast<char>(far[7] + 1);
  std::string unit = print(3);
  unit.back() = unit.back() == '9' ? '8' : static_cast<char>(unit.back() + 1);
  rows = replaced(rows, print(1), far);
  rows = replaced(rows, print(2), print(2).starts_with('-') ? print(2).substr(1) : "-" + print(2));
  rows = replaced(rows, print(3), unit);
  rows = replaced(
      rows, print(4) + "\n",
      round_to_form(FilterValues(find_table_filter("sym6")).value(Quantity::mu, 4), {false, 6})
              ->text() +
          "\n");
  rows = replaced(rows, print(5) + "\n", "0.7777777777\n");
  const CheckedTable table = check(rows);
  EXPECT_EQ(table.rows[0].verdict, PrintVerdict::certified);
  EXPECT_EQ(table.rows[1].verdict, PrintVerdict::agrees_to_digits) << table.rows[1].detail;
  EXPECT_EQ(table.rows[2].verdict, PrintVerdict::misprint) << table.rows[2].detail;
  EXPECT_EQ(table.rows[3].verdict, PrintVerdict::agrees_to_digits) << table.rows[3].detail;
  EXPECT_EQ(table.rows[4].verdict, PrintVerdict::form) << table.rows[4].detail;
  EXPECT_EQ(table.rows[5].verdict, PrintVerdict::discrepant) << table.rows[5].detail;
  for (int i : {1, 2, 3, 5}) {
    const auto place = static_cast<std::size_t>(i);
    EXPECT_EQ(table.rows[place].certified, clean.rows[place].certified);
    EXPECT_GT(table.rows[place].ulps, 0.5);
  }
}

TEST(CheckTable, KeepsTheAlphaOfEveryFilterApart) {
  PublishedTable both = read_published_table(data_folder() / "published" / "table_2.csv");
  const auto of_k2 = static_cast<std::ptrdiff_t>(both.entries.size());
  const PublishedTable d8 = read_published_table(data_folder() / "published" / "table_1.csv");
  both.entries.insert(both.entries.end(), d8.entries.begin(), d8.entries.end());
  const CheckedTable alone = published("table_2.csv"), together = check_table(both);
  EXPECT_TRUE(std::equal(
      alone.rows.begin(), alone.rows.end(), together.rows.begin(), together.rows.begin() + of_k2,
      [](const CheckedRow& a, const CheckedRow& b) { return a.verdict == b.verdict; }));
}

TEST(CheckTable, TriesNoRouteFromAnAlphaColumnWithGaps) {
  PublishedTable table = read_published_table(data_folder() / "published" / "table_2.csv");
  const auto tries_printed_alpha = [&table] {
    const CheckedTable checked = check_table(table);
    const auto& routes = checked.columns[1].routes;
    return std::any_of(routes.begin(), routes.end(), [](const RouteScore& route) {
      return route.name.starts_with("alpha as printed");
    });
  };
  EXPECT_TRUE(tries_printed_alpha());
  std::erase_if(table.entries, [](const PublishedEntry& entry) {
    return entry.quantity == Quantity::autocorrelation && entry.index == 11;
  });
  EXPECT_FALSE(tries_printed_alpha());
}

TEST(CheckTable, AsksForThreeCorrectDigits) {
  // The value is -0.63420233...
  EXPECT_EQ(check("D8,mu/mu0,1,-0.637777777777\n").rows[0].verdict, PrintVerdict::discrepant);
  EXPECT_EQ(check("D8,mu/mu0,1,-0.634277777777\n").rows[0].verdict, PrintVerdict::agrees_to_digits);
}

/// The prints of a column with `units` of the last decimal added to entry i, i counted from 0.
std::string with_errors(const std::string& rows, const std::vector<int>& units) {
  PublishedTable table = parse_published_table(header + rows, "t");
  std::string result;
  for (std::size_t i = 0; i < table.entries.size(); ++i) {
    const PublishedEntry& entry = table.entries[i];
    const certified::Rational moved =
        entry.number.value() + certified::Rational(units[i]) * entry.number.unit();
    result += entry.filter + "," + std::string(to_string(entry.quantity)) + "," +
              entry.index.text() + "," +
              certified::round_to_decimals(moved, entry.number.decimals()) + "\n";
  }
  return result;
}

TEST(CheckTable, TakesAnEditForAMisprintOnlyInAColumnThatIsOtherwiseAccurate) {
  const std::string rows = right_rows("db5", Quantity::taps, 0, 9, {false, 15});
  // 300 units are one edit away: one digit differs.
  std::vector<int> units{0, 0, 0, 300, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(check(with_errors(rows, units)).rows[3].verdict, PrintVerdict::misprint);
  units = {127, -251, 178, 300, -94, 213, 0, 161, -333, 77};
  const CheckedTable inaccurate = check(with_errors(rows, units));
  EXPECT_EQ(inaccurate.rows[3].verdict, PrintVerdict::agrees_to_digits)
      << inaccurate.rows[3].detail;
  EXPECT_FALSE(inaccurate.counts().contains(PrintVerdict::misprint));
  // An edit that is a hundred times as far off than all else is still one, and so is a sign.
  units[3] = 40'000'000;  // 0.138428145901103 has a 4 there
  units[6] = 0;
  std::string text = with_errors(rows, units);
  const std::string sixth = check(rows).rows[6].entry.printed;
  text = replaced(text, sixth, sixth.starts_with('-') ? sixth.substr(1) : "-" + sixth);
  const CheckedTable both = check(text);
  EXPECT_EQ(both.rows[3].verdict, PrintVerdict::misprint) << both.rows[3].detail;
  EXPECT_EQ(both.rows[6].verdict, PrintVerdict::misprint) << both.rows[6].detail;
}

TEST(CheckTable, FindsTheHabitOfEachNotation) {
  // What "%.10g" prints of db4, and what a table prints that is fixed above 1e-2, else scientific.
  for (
      const char* const digits :
      {"D8,h,0,0.2303778133\nD8,h,1,0.7148465706\nD8,h,2,0.6308807679\nD8,h,3,-0.02798376942\n"
       "D8,h,4,-0.1870348117\nD8,h,5,0.03084138184\nD8,h,6,0.03288301167\nD8,h,7,-0.01059740179\n",
       "D8,mu/mu0,1,-0.634202\nD8,mu/mu0,2,0.167516\nD8,mu/mu0,3,-0.0292\nD8,mu/mu0,4,-0.0039\n"}) {
    const CheckedTable table = check(digits);
    EXPECT_FALSE(table.counts().contains(PrintVerdict::form)) << digits;
  }
  FilterValues values(find_table_filter("db4"));
  std::string rows;
  for (int l = 0; l <= 6; ++l) {
    const PrintForm form = l < 3 ? PrintForm{false, 8} : PrintForm{true, 6};
    rows += "D8,mu/mu0," + std::to_string(l) + "," +
            round_to_form(values.value(Quantity::mu_normalized, l), form)->text() + "\n";
  }
  EXPECT_EQ(check(rows).counts(), (std::map<PrintVerdict, int>{{PrintVerdict::certified, 7}}));
}

TEST(CheckTable, HoldsFractionsAgainstExactValues) {
  const CheckedTable table = check(
      "D8,mu,0,342643/82248\nD8,mu,1,-2.642090\nD8,alpha,0,2/1\nD8,alpha,1,1225/1024\n"
      "D8,alpha,3,-245/1023\nD8,h,0,23/100\n");
  EXPECT_EQ(table.rows[0].verdict, PrintVerdict::certified) << table.rows[0].detail;
  EXPECT_EQ(table.rows[2].verdict, PrintVerdict::certified);
  EXPECT_EQ(table.rows[3].verdict, PrintVerdict::certified);
  EXPECT_EQ(table.rows[4].verdict, PrintVerdict::agrees_to_digits) << table.rows[4].detail;
  EXPECT_EQ(table.rows[4].certified, "-245/1024");
  EXPECT_EQ(table.rows[5].verdict, PrintVerdict::agrees_to_digits) << table.rows[5].detail;
  EXPECT_TRUE(std::isnan(table.rows[0].ulps));
  EXPECT_EQ(table.columns[0].of, 1) << "no route is looked for a fraction";
}

TEST(CheckTable, TakesAPaddedPrintForOneOfOtherForm) {
  const std::string rows = right_rows("db5", Quantity::taps, 0, 9, {false, 12});
  std::string padded = rows;
  const CheckedTable right = check(right_rows("db5", Quantity::taps, 0, 9, {false, 9}));
  const std::string first = check(rows).rows[2].entry.printed;
  padded = replaced(padded, first, right.rows[2].entry.printed + "000");
  const CheckedTable table = check(padded);
  EXPECT_EQ(table.rows[2].verdict, PrintVerdict::form);
  EXPECT_NE(table.rows[2].detail.find("right to 9 decimals"), std::string::npos)
      << table.rows[2].detail;
  EXPECT_TRUE(table.is_right());
}

TEST(CheckTable, ReadsZerosAsPrinted) {
  const CheckedTable table = check(
      "D8,mu/mu0,1,-0.634202334430\nD8,mu/mu0,2,0.167516447426\nD8,mu/mu0,7,0\nD8,mu/mu0,6,0\n"
      "D8,mu/mu0,8,-0.000000000000\nD8,mu/mu0,-7,0.000\n");
  EXPECT_EQ(table.rows[2].verdict, PrintVerdict::certified);
  EXPECT_EQ(table.rows[3].verdict, PrintVerdict::form)
      << "right at no decimals, not in the column's";
  EXPECT_EQ(table.rows[4].verdict, PrintVerdict::form) << "an exact zero has no sign";
  EXPECT_EQ(table.rows[5].verdict, PrintVerdict::form);
  const CheckedTable small = check("D8,mu/mu0,6,-0.000\nD8,mu/mu0,5,-0.000\nD8,mu/mu0,1,-0.634\n");
  EXPECT_EQ(small.rows[0].verdict, PrintVerdict::certified) << "the value is negative";
  EXPECT_EQ(small.rows[1].verdict, PrintVerdict::form) << "the value is positive";
}

TEST(CheckTable, TakesEitherNeighbourOfAnExactTie) {
  // alpha_1 of the Haar filter is 1; of db2 1.125: at two decimals a tie.
  const CheckedTable table = check("db2,alpha,1,1.12\ndb2,alpha,-1,1.13\ndb2,alpha,3,-0.13\n");
  EXPECT_EQ(table.rows[0].verdict, PrintVerdict::certified) << table.rows[0].detail;
  EXPECT_EQ(table.rows[1].verdict, PrintVerdict::certified) << table.rows[1].detail;
  EXPECT_NE(table.rows[0].detail.find("tie"), std::string::npos);
}

TEST(CheckTable, TakesAUsersOwnFilter) {
  const auto path = std::filesystem::temp_directory_path() / "wavecurve_check_table_test.json";
  io::write_file(path, R"({"taps": ["0.5", "0.5"], "sum": "1"})");
  const std::string name = path.string();
  const CheckedTable table =
      check(name + ",h*sqrt2,0,1.0\n" + name + ",h/sqrt2,1,0.5\n" + name + ",alpha,1,1.0000\n");
  std::filesystem::remove(path);
  EXPECT_TRUE(table.is_right());
  EXPECT_TRUE(refusal("no/such/filter.json,h,0,1\n").starts_with("t.csv:2: "));
}

TEST(CheckTable, SaysWhatAUsersDecimalsDoNotDecide) {
  const auto path = std::filesystem::temp_directory_path() / "wavecurve_check_undecided_test.json";
  io::write_file(path, R"({"taps": ["0.6830", "1.1830", "0.3170", "-0.1830"], "sum": "2"})");
  const std::string name = path.string();
  const CheckedTable table = check(name + ",h*sqrt2,0,0.6830127\n" + name + ",h*sqrt2,1,1.18\n" +
                                   name + ",h*sqrt2,2,0.9\n");
  std::filesystem::remove(path);
  EXPECT_EQ(table.rows[0].verdict, PrintVerdict::undecided) << table.rows[0].detail;
  EXPECT_EQ(table.rows[1].verdict, PrintVerdict::certified) << table.rows[1].detail;
  EXPECT_EQ(table.rows[2].verdict, PrintVerdict::discrepant) << table.rows[2].detail;
}

TEST(CheckTable, NamesTheLineOfWhatTheFilterDoesNotHave) {
  const std::string row = "D8,h,0,0.2\n";
  EXPECT_TRUE(refusal(row + "D9,h,0,0.2\n").starts_with("t.csv:3: unknown filter"));
  EXPECT_TRUE(refusal("nonsense,h,0,0.2\n").starts_with("t.csv:2: "));
  EXPECT_TRUE(
      refusal(row + "D8,h,8,0.2\n").starts_with("t.csv:3: the index 8 of h is out of range"));
  EXPECT_TRUE(refusal("K2,h,-5,0.2\n").starts_with("t.csv:2: the index -5"));
  EXPECT_TRUE(refusal("D8,alpha,8,0\n").starts_with("t.csv:2: the index 8"));
  EXPECT_TRUE(refusal("D8,mu,9,0\n").starts_with("t.csv:2: the index 9"));
  EXPECT_TRUE(refusal("db2,mu,0,1\n").starts_with("t.csv:2: "));
  EXPECT_TRUE(refusal(row + "db4,h,0,0.2\n").starts_with("t.csv:3: the row repeats line 2"));
  EXPECT_LT(refusal(std::string(900, 'q') + ",h,0,0.2\n").size(), 600U);
}

RC_GTEST_PROP(CheckTable, ACorrectRoundingIsAlwaysCertified, ()) {
  const std::string filter =
      *rc::gen::element<std::string>("db5", "coif1", "coif3", "sym5", "cdf9.7");
  const auto quantity = *rc::gen::element(Quantity::taps, Quantity::autocorrelation,
                                          Quantity::mu_normalized, Quantity::taps_sum_2);
  const int index = *rc::gen::inRange(1, 4);
  const PrintForm form{*rc::gen::arbitrary<bool>(), *rc::gen::inRange(1, 50)};
  const std::string row = right_rows(filter, quantity, index, index, form);
  const CheckedTable table = check(row);
  RC_ASSERT(table.rows[0].verdict == PrintVerdict::certified);
}

RC_GTEST_PROP(CheckTable, OneUnitIsNeitherCertifiedNorAMisprint, (bool up)) {
  const std::string filter = *rc::gen::element<std::string>("db5", "coif3", "sym5");
  const int index = *rc::gen::inRange(1, 4);
  const int decimals = *rc::gen::inRange(8, 30);
  FilterValues values(find_table_filter(filter));
  PrintedNumber print = *round_to_form(values.value(Quantity::mu, index), {false, decimals});
  RC_PRE(print.digits.back() != (up ? '9' : '0'));
  print.digits.back() = static_cast<char>(print.digits.back() + (up ? 1 : -1));
  const CheckedTable table =
      check(filter + ",mu," + std::to_string(index) + "," + print.text() + "\n");
  RC_ASSERT(table.rows[0].verdict == PrintVerdict::agrees_to_digits);
}

TEST(CheckTable, AnEnormousPrintIsNoCrash) {
  const CheckedTable table = check_table(parse_published_table(
      "filter,quantity,index,printed\nK2,alpha,0,-1e308\nK2,alpha,1,1.200356164723\n"
      "K2,mu/mu0,0,1.000000000000\nK2,mu/mu0,1,-0.632970245318\nK2,mu/mu0,2,0.168115616035\n",
      "t.csv"));
  EXPECT_EQ(table.rows.front().verdict, PrintVerdict::discrepant);
}

TEST(CheckTable, ManyFiltersAreRefusedBeforeTheyTakeMinutes) {
  std::string text = "# quantity: h\nfilter,index,printed\n";
  for (int order = 1; order <= 50; ++order) {
    for (int dual = order % 2 == 0 ? 2 : 1; dual <= 10; dual += 2) {
      text += "bspline" + std::to_string(order) + "." + std::to_string(dual) + ",0,0.1\n";
    }
  }
  try {
    check_table(parse_published_table(text, "t.csv"));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()),
              "t.csv:203: the table names more than 200 filters; check it in parts");
  }
}

}  // namespace
}  // namespace wavecurve::verification
