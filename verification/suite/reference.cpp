#include "verification/suite/reference.hpp"

#include <algorithm>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::verification {

namespace {

BlessedClaim bless(const ClaimResult& result) {
  return {result.claim.id, std::string(to_string(result.outcome.verdict)),
          result.outcome.own_value};
}

template <class Range>
const BlessedClaim* find(const Range& claims, const std::string& id) {
  const auto found = std::ranges::find(claims, id, &BlessedClaim::id);
  return found == claims.end() ? nullptr : &*found;
}

std::vector<BlessedClaim> bless_all(std::span<const ClaimResult> results) {
  std::vector<BlessedClaim> blessed;
  for (const ClaimResult& result : results) blessed.push_back(bless(result));
  return blessed;
}

}  // namespace

std::vector<BlessedClaim> read_reference(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return {};
  try {
    const auto document = nlohmann::json::parse(io::read_file(path));
    std::vector<BlessedClaim> claims;
    for (const auto& claim : document.at("claims")) {
      claims.push_back({claim.at("id").get<std::string>(), claim.at("verdict").get<std::string>(),
                        claim.at("own_value").get<std::string>()});
    }
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
      if (find(blessed, old.id) == nullptr) blessed.push_back(old);
    }
  }
  std::ranges::sort(blessed, [](const auto& a, const auto& b) { return precedes(a.id, b.id); });
  nlohmann::ordered_json document = {{"claims", nlohmann::ordered_json::array()}};
  for (const BlessedClaim& claim : blessed) {
    document["claims"].push_back(
        {{"id", claim.id}, {"verdict", claim.verdict}, {"own_value", claim.own_value}});
  }
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  io::write_file(path, document.dump(2) + "\n");
}

std::vector<Change> compare(std::span<const BlessedClaim> reference,
                            std::span<const ClaimResult> results, bool ignore_missing) {
  std::vector<Change> changes;
  const std::vector<BlessedClaim> run = bless_all(results);
  for (const BlessedClaim& now : run) {
    const BlessedClaim* before = find(reference, now.id);
    if (before == nullptr) {
      changes.push_back({now.id, "claim", "not in the reference", now.verdict});
      continue;
    }
    if (before->verdict != now.verdict) {
      changes.push_back({now.id, "verdict", before->verdict, now.verdict});
    }
    if (before->own_value != now.own_value) {
      changes.push_back({now.id, "own_value", before->own_value, now.own_value});
    }
  }
  for (const BlessedClaim& before : reference) {
    if (!ignore_missing && find(run, before.id) == nullptr) {
      changes.push_back({before.id, "claim", before.verdict, "no such claim"});
    }
  }
  std::ranges::stable_sort(changes,
                           [](const auto& a, const auto& b) { return precedes(a.id, b.id); });
  return changes;
}

}  // namespace wavecurve::verification
