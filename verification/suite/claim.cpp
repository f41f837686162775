#include "verification/suite/claim.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "wavecurve/io/files/detail/natural_order.hpp"

namespace wavecurve::verification {

namespace {

/// A function's static, since claims register while the program's globals are being initialised.
std::vector<Claim>& registry() {
  static std::vector<Claim> registered;
  return registered;
}

int part_of_report(std::string_view id) {
  if (id.starts_with("table-")) return 0;
  if (id.starts_with("figure-")) return 1;
  if (id.starts_with("erratum-")) return 3;
  return 2;
}

std::vector<Claim> sorted_registry() {
  std::vector<Claim> sorted = registry();
  std::ranges::sort(sorted, [](const Claim& a, const Claim& b) { return precedes(a.id, b.id); });
  const auto twice = std::ranges::adjacent_find(sorted, {}, &Claim::id);
  if (twice != sorted.end()) throw std::logic_error("two claims have the id " + twice->id);
  return sorted;
}

}  // namespace

RegisterClaim::RegisterClaim(Claim claim) { registry().push_back(std::move(claim)); }

const std::vector<Claim>& claims() {
  static const std::vector<Claim> sorted = sorted_registry();
  return sorted;
}

bool precedes(std::string_view id, std::string_view other) {
  const int part = part_of_report(id), other_part = part_of_report(other);
  if (part != other_part) return part < other_part;
  return io::naturally_precedes(id, other);
}

}  // namespace wavecurve::verification
