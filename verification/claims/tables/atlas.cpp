// The tables of filters and integrals that programs, packages and encyclopedias carry, and that
// people copy: every one judged as the publication's own are.
#include "verification/checker/atlas.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "verification/suite/claim.hpp"
#include "verification/suite/data_folder.hpp"

namespace wavecurve::verification::atlas_claim {

namespace {

Table table_of(const std::vector<AtlasEntry>& entries) {
  Table table{"Tables that people copy (verification/published/atlas)",
              {"table", "numbers", "right", "wrong", "right to", "what made it"},
              {}};
  for (const AtlasEntry& entry : entries) {
    table.rows.push_back({entry.title, std::to_string(entry.numbers), std::to_string(entry.right),
                          std::to_string(entry.wrong), fmt::format("{} digits", entry.right_digits),
                          fmt::format("{}", fmt::join(entry.causes, "; "))});
  }
  return table;
}

Outcome evaluate() {
  const std::vector<AtlasEntry> entries = judge_atlas(data_folder() / "published" / "atlas");
  const auto total = [&](int AtlasEntry::*member) {
    return std::accumulate(entries.begin(), entries.end(), 0,
                           [member](int sum, const AtlasEntry& e) { return sum + e.*member; });
  };
  const int wrong = total(&AtlasEntry::wrong);
  const auto whole = std::count_if(entries.begin(), entries.end(),
                                   [](const AtlasEntry& entry) { return entry.wrong == 0; });
  Outcome outcome;
  outcome.verdict = wrong == 0 ? ClaimVerdict::holds : ClaimVerdict::does_not_hold;
  outcome.finding = {
      "{} of {} tables are right in every number; {} of {} numbers are not right",
      {counted("tables right", static_cast<int>(whole)),
       counted("tables", static_cast<int>(entries.size())), counted("numbers wrong", wrong),
       counted("numbers", total(&AtlasEntry::numbers))}};
  outcome.summary =
      "Each table is held against certified values, in the order, sign and factor that it has; "
      "what made the wrong numbers is named where chance does not explain it.";
  outcome.evidence = {table_of(entries)};
  return outcome;
}

const RegisterClaim registered({"table-atlas", "Tables of filters and integrals that people copy",
                                "Beyond the publication",
                                "tables of packages, programs and an encyclopedia", evaluate});

}  // namespace

}  // namespace wavecurve::verification::atlas_claim
