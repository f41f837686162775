#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "verification/suite/run_claims.hpp"

namespace wavecurve::verification {

/// What a claim's verdict and value were when a person last agreed to them.
struct BlessedClaim {
  std::string id, verdict, own_value;
  bool operator==(const BlessedClaim&) const = default;
};

/// One difference between the blessed reference and a run.
struct Change {
  std::string id;
  std::string field;  ///< "verdict", "own_value", or "claim" for one that is new or gone
  std::string was, is;
  bool operator==(const Change&) const = default;
};

/// The reference file's claims; none if there is no such file. Throws std::invalid_argument naming
/// the file if it is not of the form that write_reference writes.
std::vector<BlessedClaim> read_reference(const std::filesystem::path& path);

/// Blesses the results. With `keep_others`, claims that were not run keep their entries.
void write_reference(const std::filesystem::path& path, std::span<const ClaimResult> results,
                     bool keep_others);

/// The changes in the order of the report. With `ignore_missing`, a blessed claim that was not run
/// is no change.
std::vector<Change> compare(std::span<const BlessedClaim> reference,
                            std::span<const ClaimResult> results, bool ignore_missing);

}  // namespace wavecurve::verification
