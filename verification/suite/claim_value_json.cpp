#include "verification/suite/claim_value_json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace wavecurve::verification {

namespace {

/// A whole number is written as 64, not as 64.0.
nlohmann::ordered_json plain(double number) {
  if (number == std::trunc(number) && std::abs(number) < 1e15) {
    return static_cast<long long>(number);
  }
  return number;
}

}  // namespace

nlohmann::ordered_json to_json(const ClaimValue& value) {
  nlohmann::ordered_json json = {
      {"name", value.name},
      {"number", plain(value.number)},
      {"unit", value.unit},
      {value.significant ? "significant_digits" : "decimals", value.digits},
      {"tolerance", plain(value.tolerance)}};
  if (!value.reason.empty()) json["reason"] = value.reason;
  return json;
}

ClaimValue claim_value_of_json(const io::JsonPlace& place) {
  constexpr int most_digits = 1000;
  const bool significant = place.find("significant_digits").has_value();
  ClaimValue value{place.at("name").text(),
                   place.at("number").number(),
                   place.at("unit").text(),
                   place.at(significant ? "significant_digits" : "decimals")
                       .whole_number(-most_digits, most_digits),
                   significant,
                   place.at("tolerance").number(),
                   {}};
  if (value.tolerance < 0) place.at("tolerance").refuse("at least 0");
  if (const auto reason = place.find("reason")) value.reason = reason->text();
  return value;
}

}  // namespace wavecurve::verification
