#include "benchmarks/tracking/machine_fingerprint.hpp"

#include <filesystem>
#include <fstream>
#include <sys/utsname.h>
#include <thread>

#include <fmt/format.h>

namespace wavecurve::tracking {

namespace {

namespace fs = std::filesystem;

std::string first_line(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  return std::getline(file, line) ? line : "unknown";
}

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    const auto value = line.find_first_not_of(" \t", line.find(':') + 1);
    if (value != std::string::npos) return line.substr(value);
  }
  return "unknown";
}

/// "L1 Data 32K", by level, of the first processor.
Json caches() {
  Json list = Json::array();
  const fs::path folder = "/sys/devices/system/cpu/cpu0/cache";
  for (int i = 0; fs::exists(folder / ("index" + std::to_string(i))); ++i) {
    const fs::path cache = folder / ("index" + std::to_string(i));
    list.push_back(fmt::format("L{} {} {}", first_line(cache / "level"), first_line(cache / "type"),
                               first_line(cache / "size")));
  }
  return list;
}

std::string kernel() {
  utsname name{};
  return ::uname(&name) == 0 ? std::string(name.sysname) + " " + name.release : "unknown";
}

}  // namespace

Json machine_fingerprint() {
  return {{"cpu", cpu_model()},
          {"processors", std::thread::hardware_concurrency()},
          {"caches", caches()},
          {"kernel", kernel()},
          {"governor", first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor")}};
}

std::vector<std::string> differences(const Json& before, const Json& after) {
  std::vector<std::string> list;
  // From flat to flat, so that a library is named by itself.
  const Json a = before.flatten(), b = after.flatten();
  const auto text = [](const Json& all, const std::string& key) {
    if (!all.contains(key)) return std::string("missing");
    return all.at(key).is_string() ? all.at(key).get<std::string>() : all.at(key).dump();
  };
  Json keys = a;
  for (const auto& [key, value] : b.items()) keys[key] = value;
  for (const auto& [key, value] : keys.items()) {
    const std::string was = text(a, key), is = text(b, key);
    if (was != is) list.push_back(key.substr(1) + ": " + was + ", now " + is);
  }
  return list;
}

}  // namespace wavecurve::tracking
