// Table 1: alpha, mu/mu_0 and nu/nu_0 of D8. Each print is held against the exact fraction.
#include "verification/checker/check_table.hpp"
#include "verification/checker/table_evidence.hpp"
#include "verification/suite/claim.hpp"
#include "verification/suite/data_folder.hpp"

namespace wavecurve::verification::table_1 {

namespace {

Outcome evaluate() {
  const CheckedTable table =
      check_table(read_published_table(data_folder() / "published" / "table_1.csv"));
  Outcome outcome;
  outcome.verdict = verdict_of(table);
  outcome.finding = count_finding(table);
  outcome.summary =
      outcome.verdict == ClaimVerdict::certified
          ? "Every printed decimal is the correctly rounded value of an exact fraction."
          : "Not every printed decimal is the correctly rounded true value.";
  outcome.evidence = {row_table(table)};
  return outcome;
}

const RegisterClaim registered({"table-1", "Autocorrelations and coefficients of the D8 wavelet",
                                "Section 3.2, Table 1", "24 decimals, 12 places each", evaluate});

}  // namespace

}  // namespace wavecurve::verification::table_1
