#include "verification/quantities/integral_expression.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

#include "verification/prints/printed_number.hpp"
#include "verification/quantities/entry_index.hpp"
#include "verification/quantities/grammar_reader.hpp"

namespace wavecurve::verification {

namespace {

class IntegralParser {
 public:
  explicit IntegralParser(std::string_view text) : reader_("integral", text) {}

  ProductIntegral parse(const std::optional<DyadicInterval>& interval) {
    integral_.interval = interval;
    const std::size_t most = interval ? most_factors - 1 : most_factors;
    while (!reader_.at_end()) {
      if (reader_.take_word("x")) {
        take_power();
      } else {
        if (integral_.factors.size() == most) {
          reader_.refuse(fmt::format("the end: at most {} factors{}", most,
                                     interval ? " on an interval" : ""));
        }
        take_factor();
      }
      if (!reader_.take(",")) reader_.take("*");
    }
    if (integral_.factors.empty()) reader_.refuse("phi or psi");
    settle_shifts();
    check_integral(integral_);
    return integral_;
  }

 private:
  void take_power() {
    int power = 1;
    if (reader_.take("^")) {
      const bool bracket = reader_.take("(");
      power = reader_.take_number("a power of x", highest_power);
      if (bracket) reader_.expect(")");
    }
    integral_.power += power;
    if (integral_.power > highest_power) {
      reader_.refuse(fmt::format("powers of x that add up to at most {}", highest_power));
    }
  }

  void take_factor() {
    IntegralFactor factor{reader_.take_function(), false, 0};
    if (reader_.take("(")) {
      const bool has_scale = !reader_.rest().empty() && is_digit(reader_.rest().front());
      if (has_scale) {
        const std::size_t before = reader_.place();
        const int scale = reader_.take_number("a power of two", 1 << highest_integral_level);
        if (!std::has_single_bit(static_cast<unsigned>(scale))) {
          reader_.go_back(before);
          reader_.refuse(fmt::format("a power of two up to {}", 1 << highest_integral_level));
        }
        factor.level = std::bit_width(static_cast<unsigned>(scale)) - 1;
        reader_.expect("x");
      }
      const bool has_place = has_scale || reader_.take_word("x");
      factor.shifted = !has_place || reader_.take("-");
      if (factor.shifted) reader_.take_letter(letters_);
      reader_.expect(")");
    }
    integral_.factors.push_back(factor);
  }

  /// Without letters all but the first are shifted; on the line one that is not shifted comes
  /// first.
  void settle_shifts() {
    auto& factors = integral_.factors;
    if (letters_.empty()) {
      for (std::size_t i = 1; i < factors.size(); ++i) factors[i].shifted = true;
    }
    if (integral_.interval) return;
    const auto standing = std::find_if(factors.begin(), factors.end(),
                                       [](const IntegralFactor& f) { return !f.shifted; });
    if (standing == factors.end()) {
      reader_.refuse("a factor without a letter, for on the line all may be shifted together");
    }
    std::rotate(factors.begin(), standing, standing + 1);
  }

  GrammarReader reader_;
  ProductIntegral integral_;
  std::string letters_;
};

/// One end as a multiple of 2^-highest_integral_level.
int end_of_interval(std::string_view text, std::string_view whole) {
  constexpr double farthest = 1e5;
  std::optional<EntryIndex> end;
  try {
    end = parse_entry_index(text);
  } catch (const std::invalid_argument&) {  // answered below
  }
  if (!end || end->is_tuple() || std::abs(end->first) > farthest ||
      end->dyadic_level() > highest_integral_level) {
    throw std::invalid_argument(must_be(
        "the interval", whole,
        fmt::format("a,b with integers or multiples of 1/{}, up to 10^5 in magnitude, such as 0,1",
                    1 << highest_integral_level)));
  }
  return static_cast<int>(std::ldexp(end->first, highest_integral_level));
}

}  // namespace

ProductIntegral parse_integral(std::string_view text,
                               const std::optional<DyadicInterval>& interval) {
  return IntegralParser(text).parse(interval);
}

DyadicInterval parse_interval(std::string_view text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view second = comma < text.size() ? text.substr(comma + 1) : "";
  DyadicInterval interval{end_of_interval(text.substr(0, comma), text),
                          end_of_interval(second, text), highest_integral_level};
  while (interval.level > 0 && interval.first % 2 == 0 && interval.last % 2 == 0) {
    interval.first /= 2;
    interval.last /= 2;
    --interval.level;
  }
  check_integral({{{}}, 0, interval});
  return interval;
}

bool is_up_to_x(std::string_view text) {
  std::string without_blanks(text);
  std::erase(without_blanks, ' ');
  return without_blanks == "0,x";
}

std::string to_string(const DyadicInterval& interval) {
  const auto end = [&](int numerator) {
    return EntryIndex::at(std::ldexp(numerator, -interval.level)).text();
  };
  return end(interval.first) + "," + end(interval.last);
}

std::string to_string(const ProductIntegral& integral) {
  const auto& factors = integral.factors;
  const bool is_plain = std::all_of(factors.begin(), factors.end(), [&](const IntegralFactor& f) {
    return f.level == 0 && f.shifted == (&f != &factors.front());
  });
  std::string text;
  if (integral.power > 0) text = integral.power == 1 ? "x" : fmt::format("x^{}", integral.power);
  char letter = 'l';
  for (const IntegralFactor& factor : factors) {
    if (!text.empty()) text += ", ";
    text += name_of(factor.function);
    if (is_plain) continue;
    const std::string scale = factor.level == 0 ? "" : fmt::format("{}x", 1 << factor.level);
    if (factor.shifted) {
      text += fmt::format("({}{}{})", scale, scale.empty() ? "" : " - ", letter++);
    } else if (!scale.empty()) {
      text += fmt::format("({})", scale);
    }
  }
  return text;
}

}  // namespace wavecurve::verification
