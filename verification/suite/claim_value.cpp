#include "verification/suite/claim_value.hpp"

#include <cmath>
#include <utility>

#include <fmt/args.h>
#include <fmt/format.h>

namespace wavecurve::verification {

namespace {

std::string shown(double number, int digits, bool significant) {
  return significant ? fmt::format("{:.{}g}", number, digits)
                     : fmt::format("{:.{}f}", number, digits);
}

/// The decimals that a number of so many significant digits has; negative for a large one.
int decimals_of(double number, int digits) {
  const std::string scientific = fmt::format("{:.{}e}", number, digits - 1);
  return digits - 1 - std::stoi(scientific.substr(scientific.find('e') + 1));
}

ClaimValue rounded(std::string name, double number, std::string unit, int digits,
                   bool significant) {
  ClaimValue value{std::move(name), number, std::move(unit), digits, significant, 0, {}};
  if (!std::isfinite(number)) return value;  // refused by name where the claims are run
  value.number = std::stod(shown(number, digits, significant)) + 0.0;  // and no -0
  if (significant && value.number == 0) return value;
  const int decimals = significant ? decimals_of(value.number, digits) : digits;
  // The double next to the decimal, which 0.5 * pow(10, ...) need not be.
  value.tolerance = std::stod(fmt::format("5e{}", -decimals - 1));
  return value;
}

}  // namespace

ClaimValue ClaimValue::within(double own_tolerance, std::string why) const {
  ClaimValue value = *this;
  value.tolerance = own_tolerance;
  value.reason = std::move(why);
  return value;
}

std::string ClaimValue::text() const {
  return shown(number, digits, significant) + (unit.empty() ? "" : " " + unit);
}

ClaimValue counted(std::string name, long long number, std::string unit) {
  return {std::move(name), static_cast<double>(number), std::move(unit), 0, false, 0, {}};
}

ClaimValue to_decimals(std::string name, double number, int decimals, std::string unit) {
  return rounded(std::move(name), number, std::move(unit), decimals, false);
}

ClaimValue to_digits(std::string name, double number, int digits, std::string unit) {
  return rounded(std::move(name), number, std::move(unit), digits, true);
}

std::string percent(double share, int significant_digits) {
  return fmt::format("{:.{}g}", 100 * share, significant_digits);
}

bool agrees(const ClaimValue& blessed, const ClaimValue& own) {
  // A difference of decimals that equals the tolerance may be rounded to the other side of it.
  const double allowed = blessed.tolerance * (1 + 1e-6);
  return own.unit == blessed.unit && std::abs(own.number - blessed.number) <= allowed;
}

Finding::Finding(std::string_view words, std::vector<ClaimValue> found) : values(std::move(found)) {
  fmt::dynamic_format_arg_store<fmt::format_context> texts;
  for (const ClaimValue& value : values) texts.push_back(value.text());
  sentence = fmt::vformat(fmt::string_view(words.data(), words.size()), texts);
}

}  // namespace wavecurve::verification
