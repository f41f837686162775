#include "benchmarks/pages/limit_reasons.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/json_place.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve::tracking {

namespace fs = std::filesystem;

std::string LimitReasons::text(const std::string& kernel, const std::string& shown) const {
  const auto found = of_kernel.find(kernel);
  if (found == of_kernel.end()) return "";
  if (commit == shown) return found->second;
  constexpr std::size_t short_length = 10;
  return fmt::format("(Measured at revision {}, not at this record's.) {}",
                     commit.substr(0, short_length), found->second);
}

LimitReasons read_limit_reasons(const fs::path& history) {
  fs::path latest;
  std::error_code no_folder;
  for (const auto& entry : fs::directory_iterator(history / "reasons", no_folder)) {
    if (entry.path().extension() == ".json") latest = std::max(latest, entry.path());
  }
  if (latest.empty()) return {};
  try {
    const auto document = io::parse_json(io::read_file(latest));
    const io::JsonPlace place(document);
    LimitReasons reasons{place.at("commit").text(), {}};
    for (const auto& [kernel, reason] : place.at("kernels").items()) {
      reasons.of_kernel[kernel] = reason.text();
    }
    return reasons;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(latest.string() + " holds no reasons: " + error.what());
  }
}

}  // namespace wavecurve::tracking
