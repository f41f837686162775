#include "benchmarks/tracking/record.hpp"

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::tracking {

namespace fs = std::filesystem;

Json read_record(const fs::path& path) {
  const std::string text = io::read_file(path);
  Json record = Json::parse(text, nullptr, false);
  if (!record.is_object() || !record.contains("schema") || !record["schema"].is_number_integer()) {
    throw std::invalid_argument(path.string() + " is no record: it has no number \"schema\"");
  }
  if (record["schema"].get<int>() > record_schema) {
    throw std::invalid_argument(path.string() + " has schema " + record["schema"].dump() +
                                "; at most " + std::to_string(record_schema) + " is known here");
  }
  return record;
}

fs::path append_record(const fs::path& history, const Json& record) {
  fs::create_directories(history);
  std::string stem = record.at("date").get<std::string>() + "-" +
                     record.at("revision").at("commit").get<std::string>().substr(0, 10);
  std::ranges::replace(stem, ':', '-');
  fs::path path = history / (stem + ".json");
  for (int i = 2; fs::exists(path); ++i)
    path = history / (stem + "-" + std::to_string(i) + ".json");
  io::write_file(path, record.dump(1) + "\n");
  return path;
}

std::vector<Json> read_history(const fs::path& history) {
  std::vector<Json> records;
  if (!fs::is_directory(history)) return records;
  for (const auto& entry : fs::directory_iterator(history)) {
    if (entry.path().extension() != ".json") continue;
    try {
      records.push_back(read_record(entry.path()));
    } catch (const std::invalid_argument&) {
      continue;
    }
  }
  std::ranges::sort(records, {}, [](const Json& record) { return record.value("date", ""); });
  return records;
}

}  // namespace wavecurve::tracking
