#include "reports/terminal_table.hpp"

#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace wavecurve::reports {
namespace {

using verification::ClaimResult;
using verification::Verdict;

ClaimResult result(std::string id, Verdict verdict, std::string own_value) {
  return {{std::move(id), "", "", "", {}}, {verdict, std::move(own_value), "", {}}};
}

TEST(TerminalTable, OneAlignedLineAClaimThenTheCounts) {
  const std::string table = terminal_table(
      {result("table-1", Verdict::certified, "all"), result("t", Verdict::does_not_hold, "46.3 %"),
       result("u", Verdict::certified, "x")},
      0);
  EXPECT_EQ(table,
            "table-1  certified      all\n"
            "t        does-not-hold  46.3 %\n"
            "u        certified      x\n"
            "\n"
            "3 claims: 2 certified, 1 does-not-hold\n");
}

TEST(TerminalTable, CutsLinesToTheWidthInCharactersNotBytes) {
  const std::string table = terminal_table(
      {result("a", Verdict::holds, "μμμμμμμμμμμμ"), result("b", Verdict::holds, "μ")}, 15);
  EXPECT_TRUE(table.starts_with("a  holds  μμμμ…\nb  holds  μ\n")) << table;
}

TEST(TerminalTable, ANewlineOrAnEscapeInAValueDoesNotReachTheTerminal) {
  const std::string table = terminal_table({result("a", Verdict::holds, "1\n2\x1b[31m")}, 0);
  EXPECT_EQ(table, "a  holds  1 2 [31m\n\n1 claim: 1 holds\n");
}

}  // namespace
}  // namespace wavecurve::reports
