#pragma once

#include <nlohmann/json_fwd.hpp>

#include "wavecurve/io/files/detail/json_place.hpp"

#include "verification/suite/claim_value.hpp"

namespace wavecurve::verification {

/// The form that a value has in report.json and in the blessed reference (docs/report-json.md):
///   {"name", "number", "unit", "decimals" or "significant_digits", "tolerance", "reason"}
/// without a reason where there is none.
nlohmann::ordered_json to_json(const ClaimValue& value);

/// The inverse. Throws std::invalid_argument naming the place for what is no such object.
ClaimValue claim_value_of_json(const io::JsonPlace& place);

}  // namespace wavecurve::verification
