#include "benchmarks/tracking/record.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "wavecurve/io/files/detail/folder_lock.hpp"
#include "wavecurve/io/files/detail/json_place.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "benchmarks/tracking/check_record.hpp"

namespace wavecurve::tracking {

namespace fs = std::filesystem;

Json read_record(const fs::path& path) {
  const std::string text = io::read_file(path);
  try {
    Json record = io::parse_ordered_json(text);
    io::OrderedJsonPlace(record).at("schema").whole_number(1, record_schema);
    check_record(record);
    return record;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path.string() + " is no record: " + error.what());
  }
}

fs::path append_record(const fs::path& history, const Json& record) {
  fs::create_directories(history);
  std::string stem = record.at("date").get<std::string>() + "-" +
                     record.at("revision").at("commit").get<std::string>().substr(0, 10);
  std::ranges::replace(stem, ':', '-');
  // Records of two runs that end in the same second get two names.
  const io::FolderLock one_at_a_time(history, io::IfLocked::wait);
  fs::path path = history / (stem + ".json");
  for (int i = 2; fs::exists(path); ++i)
    path = history / (stem + "-" + std::to_string(i) + ".json");
  io::write_file(path, io::json_text(record, 1) + "\n");
  return path;
}

namespace {

/// Since 1970, of a date such as 2026-01-31T12:00:00+02:00 or ...Z; of another text 0.
long long seconds_of(const std::string& date) {
  std::tm parts{};
  int hours = 0, minutes = 0;
  const char* offset = ::strptime(date.c_str(), "%Y-%m-%dT%H:%M:%S", &parts);
  if (!offset) return 0;
  if (std::sscanf(offset, "%3d:%2d", &hours, &minutes) == 2 && *offset == '-') minutes = -minutes;
  return static_cast<long long>(::timegm(&parts)) - 3600LL * hours - 60LL * minutes;
}

}  // namespace

History read_history(const fs::path& history) {
  History result;
  if (!fs::is_directory(history)) return result;
  for (const auto& entry : fs::directory_iterator(history)) {
    if (entry.path().extension() != ".json") continue;
    try {
      result.records.push_back(read_record(entry.path()));
    } catch (const std::invalid_argument& error) {
      result.refused.emplace_back(error.what());
    }
  }
  std::ranges::sort(result.refused);
  std::ranges::sort(result.records, {}, [](const Json& record) {
    const std::string date = record.value("date", "");
    const auto revision = record.find("revision");
    const bool is_dated = revision != record.end() && revision->is_object() &&
                          revision->contains("date") && revision->at("date").is_string();
    return std::pair(seconds_of(is_dated ? revision->at("date").get<std::string>() : date), date);
  });
  return result;
}

}  // namespace wavecurve::tracking
