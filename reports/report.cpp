#include "reports/report.hpp"

#include <charconv>
#include <cstdlib>
#include <ctime>
#include <map>
#include <stdexcept>
#include <string_view>

namespace wavecurve::reports {

namespace {

std::time_t parse_epoch(std::string_view text) {
  long long seconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  // The year 9999 is the last that the date's format has room for.
  const bool valid = error == std::errc() && end == text.data() + text.size() && seconds >= 0 &&
                     seconds <= 253402300799;
  if (!valid) {
    throw std::invalid_argument("SOURCE_DATE_EPOCH is \"" + std::string(text) +
                                "\", not a number of seconds from 0 to 253402300799");
  }
  return static_cast<std::time_t>(seconds);
}

}  // namespace

std::vector<std::pair<verification::ClaimVerdict, int>> count_verdicts(
    const std::vector<verification::ClaimResult>& results) {
  std::map<verification::ClaimVerdict, int> counts;
  for (const auto& result : results) ++counts[result.outcome.verdict];
  return {counts.begin(), counts.end()};
}

std::string date_of_report() {
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t time = epoch != nullptr ? parse_epoch(epoch) : std::time(nullptr);
  std::tm utc{};
  gmtime_r(&time, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace wavecurve::reports
