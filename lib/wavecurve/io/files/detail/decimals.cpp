#include "wavecurve/io/files/detail/decimals.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/elementary/logarithm.hpp"
#include "wavecurve/elementary/root.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::io {

Decimals::Decimals(int places) : places_(places), power_(whole_power(10, places)) {
  check_between("the number of decimal places", places, 0, 15);
}

Decimals Decimals::for_box(const ViewBox& box, double accuracy) {
  const double unit = accuracy * std::max(box.width, box.height);
  if (!(unit > 0)) throw std::invalid_argument(must_be("accuracy", accuracy, "above 0"));
  // The slack lets 1e-4 of 100 have two places, although neither is a binary fraction.
  const double places = std::ceil(-logarithm_10(unit) - 1e-9);
  return Decimals(static_cast<int>(std::clamp(places, 0.0, 15.0)));
}

void Decimals::append(std::string& text, double value) const {
  const double scaled = std::round(value * power_);
  if (!(std::abs(scaled) < 1e15)) {
    text += fmt::format("{:.{}f}", value, places_);
    return;
  }
  if (scaled < 0) text += '-';
  const fmt::format_int digits(static_cast<long long>(std::abs(scaled)));
  const auto size = static_cast<int>(digits.size());
  if (size > places_) {
    text.append(digits.data(), digits.size() - static_cast<std::size_t>(places_));
  } else {
    text += '0';
  }
  if (scaled == 0 || places_ == 0) return;
  text += '.';
  text.append(static_cast<std::size_t>(std::max(places_ - size, 0)), '0');
  const int behind = std::min(size, places_);
  text.append(digits.data() + size - behind, static_cast<std::size_t>(behind));
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
}

std::string Decimals::text(double value) const {
  std::string result;
  append(result, value);
  return result;
}

double Decimals::rounded(double value) const { return std::round(value * power_) / power_; }

}  // namespace wavecurve::io
