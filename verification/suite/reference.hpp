#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "verification/suite/run_claims.hpp"

namespace wavecurve::verification {

/// The schema of the blessed reference and of report.json (docs/report-json.md). Version 1 held a sentence in the place of values.
constexpr int schema_version = 2;

/// What a claim's verdict and values were when a person last agreed to them. Words are free: what
/// the claim says about them is not kept.
struct BlessedClaim {
  std::string id, verdict;
  std::vector<ClaimValue> values;
  bool operator==(const BlessedClaim&) const = default;
};

/// One difference between the blessed reference and a run.
struct Change {
  std::string id;
  std::string what;  ///< "verdict", "value NAME", or "claim" for one that is new or gone
  std::string blessed, own;
  bool operator==(const Change&) const = default;
};

/// The reference file's claims. Throws std::invalid_argument naming the file, and the place in it, if
/// it cannot be read, is not of the form that write_reference writes, or of another schema version.
std::vector<BlessedClaim> read_reference(const std::filesystem::path& path);

/// Blesses the results. A claim whose computation failed keeps the entry that it had, if any, and with
/// `keep_others` so do the claims that were not run. Throws as read_reference does where there is a
/// file whose entries are to be kept, and as io::write_file does.
void write_reference(const std::filesystem::path& path, std::span<const ClaimResult> results,
                     bool keep_others);

/// The changes in the order of the report: verdicts, and values that do not agree (claim_value.hpp),
/// are missing or are additional. A claim whose computation failed is not compared; with
/// `ignore_missing`, a blessed claim that was not run is no change.
std::vector<Change> compare(std::span<const BlessedClaim> reference,
                            std::span<const ClaimResult> results, bool ignore_missing);

}  // namespace wavecurve::verification
