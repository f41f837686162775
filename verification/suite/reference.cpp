#include "verification/suite/reference.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "verification/suite/claim_value_json.hpp"

namespace wavecurve::verification {

namespace {

BlessedClaim bless(const ClaimResult& result) {
  return {result.claim.id, std::string(to_string(result.outcome.verdict)),
          result.outcome.finding.values};
}

/// The element whose `key` is this, or nullptr.
template <class Range, class Member>
auto find(const Range& range, const std::string& key, Member member) {
  const auto found = std::ranges::find(range, key, member);
  return found == std::ranges::end(range) ? nullptr : &*found;
}

std::vector<BlessedClaim> bless_all(std::span<const ClaimResult> results) {
  std::vector<BlessedClaim> blessed;
  for (const ClaimResult& result : results) blessed.push_back(bless(result));
  return blessed;
}

BlessedClaim claim_of_json(const nlohmann::json& json) {
  BlessedClaim claim{json.at("id").get<std::string>(), json.at("verdict").get<std::string>(), {}};
  for (const auto& value : json.at("values")) claim.values.push_back(claim_value_of_json(value));
  return claim;
}

nlohmann::ordered_json to_json(const BlessedClaim& claim) {
  nlohmann::ordered_json json = {
      {"id", claim.id}, {"verdict", claim.verdict}, {"values", nlohmann::ordered_json::array()}};
  for (const ClaimValue& value : claim.values) json["values"].push_back(to_json(value));
  return json;
}

/// Files of version 1 did not say so.
void require_schema(const std::filesystem::path& path, const nlohmann::json& document) {
  const auto found = document.contains("schema") ? document.at("schema") : nlohmann::json(1);
  if (found != schema_version) {
    throw std::invalid_argument(fmt::format(
        "{}: schema version {}, but this program reads version {} (wavecurve verify --bless, "
        "without --only, writes the file anew)",
        path.string(), found.dump(), schema_version));
  }
}

void compare_values(const BlessedClaim& before, const BlessedClaim& now,
                    std::vector<Change>& changes) {
  const auto add = [&](const std::string& name, std::string blessed, std::string own) {
    changes.push_back({now.id, "value " + name, std::move(blessed), std::move(own)});
  };
  for (const ClaimValue& blessed : before.values) {
    const ClaimValue* own = find(now.values, blessed.name, &ClaimValue::name);
    if (own == nullptr) {
      add(blessed.name, blessed.text(), "no such value");
    } else if (!agrees(blessed, *own)) {
      add(blessed.name, fmt::format("{} (tolerance {})", blessed.text(), blessed.tolerance),
          own->text());
    }
  }
  for (const ClaimValue& own : now.values) {
    if (find(before.values, own.name, &ClaimValue::name) == nullptr) {
      add(own.name, "no such value", own.text());
    }
  }
}

}  // namespace

std::vector<BlessedClaim> read_reference(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return {};
  try {
    const auto document = io::read_json(path);
    const auto& listed = document.at("claims");
    require_schema(path, document);
    std::vector<BlessedClaim> claims;
    for (const auto& claim : listed) claims.push_back(claim_of_json(claim));
    return claims;
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(path.string() + " is no reference file: " + error.what());
  }
}

void write_reference(const std::filesystem::path& path, std::span<const ClaimResult> results,
                     bool keep_others) {
  std::vector<BlessedClaim> blessed = bless_all(results);
  if (keep_others) {
    for (const BlessedClaim& old : read_reference(path)) {
      if (find(blessed, old.id, &BlessedClaim::id) == nullptr) blessed.push_back(old);
    }
  }
  std::ranges::sort(blessed, [](const auto& a, const auto& b) { return precedes(a.id, b.id); });
  nlohmann::ordered_json document = {{"schema", schema_version},
                                     {"claims", nlohmann::ordered_json::array()}};
  for (const BlessedClaim& claim : blessed) document["claims"].push_back(to_json(claim));
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  io::write_file(path, document.dump(2) + "\n");
}

std::vector<Change> compare(std::span<const BlessedClaim> reference,
                            std::span<const ClaimResult> results, bool ignore_missing) {
  std::vector<Change> changes;
  const std::vector<BlessedClaim> run = bless_all(results);
  for (const BlessedClaim& now : run) {
    const BlessedClaim* before = find(reference, now.id, &BlessedClaim::id);
    if (before == nullptr) {
      changes.push_back({now.id, "claim", "no such claim", now.verdict});
      continue;
    }
    if (before->verdict != now.verdict) {
      changes.push_back({now.id, "verdict", before->verdict, now.verdict});
    }
    compare_values(*before, now, changes);
  }
  for (const BlessedClaim& before : reference) {
    if (!ignore_missing && find(run, before.id, &BlessedClaim::id) == nullptr) {
      changes.push_back({before.id, "claim", before.verdict, "no such claim"});
    }
  }
  std::ranges::stable_sort(changes,
                           [](const auto& a, const auto& b) { return precedes(a.id, b.id); });
  return changes;
}

}  // namespace wavecurve::verification
