#include <algorithm>

#include <fmt/format.h>

#include "wavecurve/certified/detail/families/family.hpp"
#include "wavecurve/certified/find_filter.hpp"

namespace wavecurve::certified {

namespace {

constexpr std::string_view pair_prefix = "bior", reversed_prefix = "rbio";

/// rbioD.E is biorD.E, whatever that name means, with its two sides exchanged.
FilterDefinition define_reversed(std::string_view name) {
  const auto orders = name.substr(reversed_prefix.size());
  return dual(find_filter(fmt::format("{}{}", pair_prefix, orders)), std::string(name));
}

}  // namespace

Family reversed_pair_family(const std::vector<Family>& others) {
  Family family{"rbio1.1-rbio6.8 (biorD.E with its sides exchanged)", {}, {}, {}};
  const auto add = [&](const std::string& name) {
    if (!name.starts_with(pair_prefix)) return;
    family.members.push_back(fmt::format("{}{}", reversed_prefix, name.substr(pair_prefix.size())));
  };
  for (const Family& other : others) {
    for (const auto& [alias, name] : other.aliases) add(alias);
    for (const std::string& name : other.members) add(name);
  }
  family.define = [names = family.members](std::string_view name) {
    const bool known = std::find(names.begin(), names.end(), name) != names.end();
    return known ? std::optional(define_reversed(name)) : std::nullopt;
  };
  return family;
}

}  // namespace wavecurve::certified
