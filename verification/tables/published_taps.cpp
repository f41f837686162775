#include "verification/tables/published_taps.hpp"

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <vector>

#include "wavecurve/certified/ball.hpp"
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

Eigen::VectorXd PublishedTaps::taps() const {
  Eigen::VectorXd result(static_cast<Eigen::Index>(numbers.size()));
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    result[i] = certified::Ball(numbers[static_cast<std::size_t>(i)]).to_double();
  }
  return result * factor_to_sum_sqrt2(normalization);
}

std::optional<PublishedTaps> find_published_taps(std::string_view filter) {
  for (const fs::path& path : tap_tables()) {
    const PublishedTable table = read_published_table(path);
    PublishedTaps taps{table.title, {}, Quantity::taps};
    for (const PublishedEntry& entry : table.entries) {
      if (certified::canonical_filter_name(entry.filter) != filter) continue;
      taps.numbers.push_back(entry.number.value());
      taps.normalization = entry.quantity;
    }
    if (!taps.numbers.empty()) return taps;
  }
  return std::nullopt;
}

}  // namespace wavecurve::verification
