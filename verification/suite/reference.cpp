#include "verification/suite/reference.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/folder_lock.hpp"
#include "wavecurve/io/files/detail/json_place.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "verification/suite/claim_value_json.hpp"

namespace wavecurve::verification {

namespace {

bool has_failed(const ClaimResult& result) { return !result.outcome.failure.empty(); }

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
  for (const ClaimResult& result : results) {
    if (!has_failed(result)) blessed.push_back(bless(result));
  }
  return blessed;
}

BlessedClaim claim_of_json(const io::JsonPlace& place) {
  BlessedClaim claim{place.at("id").text(), place.at("verdict").text(), {}};
  if (!is_claim_verdict(claim.verdict)) place.at("verdict").refuse("a verdict of a claim");
  for (const auto& value : place.at("values").elements()) {
    claim.values.push_back(claim_value_of_json(value));
  }
  return claim;
}

nlohmann::ordered_json to_json(const BlessedClaim& claim) {
  nlohmann::ordered_json json = {
      {"id", claim.id}, {"verdict", claim.verdict}, {"values", nlohmann::ordered_json::array()}};
  for (const ClaimValue& value : claim.values) json["values"].push_back(to_json(value));
  return json;
}

/// Files of version 1 did not say so.
void require_schema(const io::JsonPlace& document) {
  const auto found = document.find("schema");
  if (found && found->value() == schema_version) return;
  throw std::invalid_argument(
      fmt::format("schema version {}, but this program reads version {} (wavecurve verify --bless, "
                  "without --only, writes the file anew)",
                  found ? found->value().dump() : "1", schema_version));
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
  const auto document = io::read_json(path);
  try {
    const io::JsonPlace place(document);
    const auto listed = place.at("claims").elements();
    require_schema(place);
    std::vector<BlessedClaim> claims;
    for (const io::JsonPlace& claim : listed) claims.push_back(claim_of_json(claim));
    return claims;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path.string() + ": " + error.what());
  }
}

void write_reference(const std::filesystem::path& path, std::span<const ClaimResult> results,
                     bool keep_others) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::filesystem::create_directories(folder);
  // Between reading and writing, no other run may bless its own claims, which would be lost.
  const io::FolderLock one_at_a_time(folder, io::IfLocked::wait);
  std::vector<BlessedClaim> blessed = bless_all(results);
  const auto is_kept = [&](const BlessedClaim& old) {
    const bool has_run = std::ranges::any_of(
        results, [&](const ClaimResult& result) { return result.claim.id == old.id; });
    return find(blessed, old.id, &BlessedClaim::id) == nullptr && (keep_others || has_run);
  };
  const bool has_failure = std::ranges::any_of(results, has_failed);
  if ((keep_others || has_failure) && std::filesystem::exists(path)) {
    const std::vector<BlessedClaim> before = read_reference(path);
    std::ranges::copy_if(before, std::back_inserter(blessed), is_kept);
  }
  std::ranges::sort(blessed, [](const auto& a, const auto& b) { return precedes(a.id, b.id); });
  nlohmann::ordered_json document = {{"schema", schema_version},
                                     {"claims", nlohmann::ordered_json::array()}};
  for (const BlessedClaim& claim : blessed) document["claims"].push_back(to_json(claim));
  io::write_file(path, io::json_text(document, 2) + "\n");
}

std::vector<Change> compare(std::span<const BlessedClaim> reference,
                            std::span<const ClaimResult> results, bool ignore_missing) {
  std::vector<Change> changes;
  for (const BlessedClaim& now : bless_all(results)) {
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
  const auto was_run = [&](const std::string& id) {
    return std::ranges::any_of(results, [&](const auto& result) { return result.claim.id == id; });
  };
  for (const BlessedClaim& before : reference) {
    if (!ignore_missing && !was_run(before.id)) {
      changes.push_back({before.id, "claim", before.verdict, "no such claim"});
    }
  }
  std::ranges::stable_sort(changes,
                           [](const auto& a, const auto& b) { return precedes(a.id, b.id); });
  return changes;
}

}  // namespace wavecurve::verification
