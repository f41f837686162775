#include "reports/terminal_table.hpp"

#include <sstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace wavecurve::reports {
namespace {

using verification::ClaimResult;
using verification::ClaimVerdict;

ClaimResult result(std::string id, ClaimVerdict verdict, std::string_view sentence) {
  return {{std::move(id), "", "", "", {}}, {verdict, {sentence, {}}, "", {}}};
}

TEST(TerminalTable, OneAlignedLineAClaimThenTheCounts) {
  const std::string table = terminal_table({result("table-1", ClaimVerdict::certified, "all"),
                                            result("t", ClaimVerdict::does_not_hold, "46.3 %"),
                                            result("u", ClaimVerdict::certified, "x")},
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
      {result("a", ClaimVerdict::holds, "μμμμμμμμμμμμ"), result("b", ClaimVerdict::holds, "μ")},
      15);
  EXPECT_TRUE(table.starts_with("a  holds  μμμμ…\nb  holds  μ\n")) << table;
}

TEST(TerminalTable, ANewlineOrAnEscapeInASentenceDoesNotReachTheTerminal) {
  const std::string table = terminal_table({result("a", ClaimVerdict::holds, "1\n2\x1b[31m")}, 0);
  EXPECT_EQ(table, "a  holds  1 2 [31m\n\n1 claim: 1 holds\n");
}

}  // namespace
}  // namespace wavecurve::reports
