#include "verification/suite/claim.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <utility>

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

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Removes and returns the leading run of digits, or of other characters.
std::string_view take_run(std::string_view& text) {
  const bool digits = is_digit(text.front());
  const auto end =
      std::find_if(text.begin(), text.end(), [digits](char c) { return is_digit(c) != digits; });
  const std::string_view run = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(run.size());
  return run;
}

/// Negative, zero or positive as `a` precedes, equals or follows `b`.
int compare_runs(std::string_view a, std::string_view b) {
  const bool numbers = is_digit(a.front()) && is_digit(b.front());
  if (numbers && a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  return a.compare(b);
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
  while (!id.empty() && !other.empty()) {
    const int order = compare_runs(take_run(id), take_run(other));
    if (order != 0) return order < 0;
  }
  return id.empty() && !other.empty();
}

}  // namespace wavecurve::verification
