#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace wavecurve::tracking {

using Json = nlohmann::ordered_json;

/// What was measured of one revision at one time: a JSON document, kept as it was read, so that
/// fields that this version does not know survive. The schema is described in
/// docs/how-to-read-benchmarks.md.
constexpr int record_schema = 1;

/// Throws std::invalid_argument naming the file where it cannot be read or is no record: no JSON, no
/// schema number or one above record_schema, or a place that is not as it must be (check_record).
Json read_record(const std::filesystem::path& path);

/// Adds the record to the history as a file of its own, DATE-REVISION.json, whole or not at all,
/// and never instead of another; returns its path. Throws what io::write_file throws.
std::filesystem::path append_record(const std::filesystem::path& history, const Json& record);

struct History {
  std::vector<Json> records;         ///< by the date of the revision, then of the record
  std::vector<std::string> refused;  ///< what read_record says of the files that are none
};

/// The records of a folder, all its files *.json. No folder: no records.
History read_history(const std::filesystem::path& history);

}  // namespace wavecurve::tracking
