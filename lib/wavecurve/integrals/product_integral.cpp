#include "wavecurve/integrals/product_integral.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

namespace {

std::string dyadic_text(int numerator, int level) {
  while (level > 0 && numerator % 2 == 0) {
    numerator /= 2;
    --level;
  }
  return level == 0 ? std::to_string(numerator) : fmt::format("{}/{}", numerator, 1 << level);
}

std::string factor_text(const IntegralFactor& factor, char letter) {
  const std::string place = factor.level == 0 ? "x" : std::to_string(1 << factor.level) + "x";
  return name_of(factor.function) +
         (factor.shifted ? fmt::format("({} - {})", place, letter) : fmt::format("({})", place));
}

void check_interval(const DyadicInterval& interval) {
  check_between("level of an interval's ends", interval.level, 0, highest_integral_level);
  if (interval.first < interval.last) return;
  throw std::invalid_argument(fmt::format(
      "the interval from {} to {} is {}: its ends must be in ascending order",
      dyadic_text(interval.first, interval.level), dyadic_text(interval.last, interval.level),
      interval.first == interval.last ? "empty" : "reversed"));
}

void check_period(const ProductIntegral& integral) {
  check_between("period of an integral", *integral.period, 1, most_integrals);
  bool is_plain = integral.power == 0 && !integral.interval;
  long count = 1;
  for (const IntegralFactor& factor : integral.factors) {
    is_plain &= factor.level == 0;
    if (factor.shifted) count *= *integral.period;
    check_between("number of integrals of that period", count, 1, most_integrals);
  }
  if (!is_plain) {
    throw std::invalid_argument(
        "periodic factors take neither powers of x, nor an interval, nor finer levels");
  }
}

}  // namespace

std::string name_of(const ProductIntegral& integral) {
  std::string text = "int";
  if (integral.power == 1) text += " x";
  if (integral.power > 1) text += fmt::format(" x^{}", integral.power);
  char letter = 'l';
  for (const IntegralFactor& factor : integral.factors) {
    text += fmt::format(" {}", factor_text(factor, letter));
    if (factor.shifted) ++letter;
  }
  text += " dx";
  if (const auto& interval = integral.interval) {
    text += fmt::format(" over [{}, {}]", dyadic_text(interval->first, interval->level),
                        dyadic_text(interval->last, interval->level));
  }
  if (integral.period) text += fmt::format(" over the period {}", *integral.period);
  return text;
}

void check_integral(const ProductIntegral& integral) {
  const auto& [factors, power, interval, period] = integral;
  check_between(interval ? "number of factors of an integral over an interval"
                         : "number of factors of an integral",
                static_cast<long>(factors.size()), 1, interval ? most_factors - 1 : most_factors);
  check_between("power of x", power, 0, highest_power);
  for (const IntegralFactor& factor : factors) {
    check_between("derivative order", factor.function.derivative, 0, highest_derivative);
    check_between("level of a factor", factor.level, 0, highest_integral_level);
  }
  if (period) check_period(integral);
  if (interval) {
    check_interval(*interval);
  } else if (factors.front().shifted) {
    throw std::invalid_argument(
        "the first factor of an integral over the line must not be shifted");
  }
}

}  // namespace wavecurve
