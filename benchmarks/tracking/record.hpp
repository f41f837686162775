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

/// Throws std::invalid_argument where the file cannot be read or is no record: no JSON, no schema
/// number, or one above record_schema.
Json read_record(const std::filesystem::path& path);

/// Adds the record to the history as a file of its own, DATE-REVISION.json, whole or not at all,
/// and never instead of another; returns its path. Throws what io::write_file throws.
std::filesystem::path append_record(const std::filesystem::path& history, const Json& record);

/// All records of a folder, by date. Files that are none, such as what is left of a killed run,
/// are passed over. No folder: no records.
std::vector<Json> read_history(const std::filesystem::path& history);

}  // namespace wavecurve::tracking
