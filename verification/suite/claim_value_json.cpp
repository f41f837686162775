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

ClaimValue claim_value_of_json(const nlohmann::json& json) {
  const bool significant = json.contains("significant_digits");
  return {json.at("name").get<std::string>(),
          json.at("number").get<double>(),
          json.at("unit").get<std::string>(),
          json.at(significant ? "significant_digits" : "decimals").get<int>(),
          significant,
          json.at("tolerance").get<double>(),
          json.value("reason", std::string())};
}

}  // namespace wavecurve::verification
