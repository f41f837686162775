#include "verification/tables/published_taps.hpp"

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <vector>

#include "wavecurve/certified/find_filter.hpp"

#include "verification/suite/data_folder.hpp"
#include "verification/tables/published_table.hpp"

namespace wavecurve::verification {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> tap_tables() {
  std::vector<fs::path> paths;
  for (const auto& file : fs::directory_iterator(data_folder() / "published")) {
    const std::string name = file.path().filename().string();
    if (name.starts_with("taps_") && name.ends_with(".csv")) paths.push_back(file.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

double factor_to_sum_sqrt2(const Quantity& quantity) {
  if (quantity == Quantity::taps_sum_2) return 1 / std::numbers::sqrt2;
  if (quantity == Quantity::taps_sum_1) return std::numbers::sqrt2;
  return 1;
}

}  // namespace

std::optional<PublishedTaps> find_published_taps(std::string_view filter) {
  for (const fs::path& path : tap_tables()) {
    const PublishedTable table = read_published_table(path);
    std::vector<double> taps;
    for (const PublishedEntry& entry : table.entries) {
      if (!is_taps(entry.quantity)) continue;
      if (certified::canonical_filter_name(entry.filter) != filter) continue;
      taps.push_back(entry.number.to_double() * factor_to_sum_sqrt2(entry.quantity));
    }
    if (taps.empty()) continue;
    const auto size = static_cast<Eigen::Index>(taps.size());
    return PublishedTaps{table.title, Eigen::Map<const Eigen::VectorXd>(taps.data(), size)};
  }
  return std::nullopt;
}

}  // namespace wavecurve::verification
