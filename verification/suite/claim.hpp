#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "verification/suite/claim_value.hpp"
#include "verification/suite/claim_verdict.hpp"

namespace wavecurve::verification {

/// Cells are finished text: rounding is the claim's business, layout the report's.
struct Table {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// A chart drawn by gnuplot. `script` holds the plot commands without `set terminal`/`set output`;
/// it reads the table's rows from the file name in the gnuplot variable `data` (columns separated
/// by tabs, first line the column names). The table is shown beneath the chart.
struct Chart {
  std::string id;  ///< file name without ending, unique in the report
  Table data;
  std::string script;
};

/// A finished picture, with the numbers that it shows as a table beneath.
struct Picture {
  std::string id;
  std::string svg;
  std::string alternative_text;
  Table data;
};

struct Paragraph {
  std::string text;
};

using Evidence = std::variant<Paragraph, Table, Chart, Picture>;

/// The result of evaluating a claim. Everything in it is computed, and the same in every run.
struct Outcome {
  ClaimVerdict verdict = ClaimVerdict::undecided;
  Finding finding;      ///< our numbers, and a sentence made from them
  std::string summary;  ///< why the verdict is what it is, one or two sentences
  std::vector<Evidence> evidence;
  /// Why the computation failed; empty where it did not. What failed is neither compared nor blessed.
  std::string failure = {};
};

/// One table, figure or statement of the publication.
struct Claim {
  std::string id;  ///< "table-1", "off-diagonal-energy"
  std::string title;
  std::string location;  ///< "Section 3.2, Table 1"
  std::string printed;   ///< what the publication says, in its own words or numbers
  std::function<Outcome()> evaluate;
};

/// Put one of these at namespace scope in a file of verification/claims and the claim is part of
/// the suite: `const RegisterClaim registered({...});`
struct RegisterClaim {
  explicit RegisterClaim(Claim claim);
};

/// All registered claims, ordered by id as a reader would: the tables, the figures, the statements,
/// the errata. Throws std::logic_error if two claims have the same id.
const std::vector<Claim>& claims();

/// The order of claims(); numbers within ids count as numbers, so figure-9 precedes figure-10.
bool precedes(std::string_view id, std::string_view other);

}  // namespace wavecurve::verification
