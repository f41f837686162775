#include "verification/quantities/quantity.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "verification/prints/printed_number.hpp"
#include "verification/quantities/quantity_families.hpp"

namespace wavecurve::verification {

namespace {

using certified::BasisFunction;

Quantity of_family(std::string_view name, std::vector<Factor> factors, int half_powers = 0) {
  return {&quantity_family(name), std::move(factors), half_powers, false, false};
}

const Quantity& filter_taps(bool wavelet, bool dual) {
  static const std::array<Quantity, 4> all{
      of_family("h", {{{false, false, 0}, 0}}), of_family("h", {{{true, false, 0}, 0}}),
      of_family("h", {{{false, true, 0}, 0}}), of_family("h", {{{true, true, 0}, 0}})};
  return all[(wavelet ? 1u : 0u) + (dual ? 2u : 0u)];
}

/// int f'(x) f'(x - l) dx.
Quantity product_of_slopes(bool wavelet) {
  const BasisFunction f{wavelet, false, 1};
  return of_family("int", {{f, 0}, {f, 1}});
}

Quantity by_first(Quantity quantity) {
  quantity.divided_by_first = true;
  return quantity;
}

/// Names that stand for something longer; the first of equals is how it is written.
const std::vector<std::pair<std::string_view, Quantity>>& short_names() {
  static const std::vector<std::pair<std::string_view, Quantity>> names{
      {"h", filter_taps(false, false)},
      {"g", filter_taps(true, false)},
      {"dual(h)", filter_taps(false, true)},
      {"dual(g)", filter_taps(true, true)},
      {"h~", filter_taps(false, true)},
      {"g~", filter_taps(true, true)},
      {"mu", product_of_slopes(false)},
      {"nu", product_of_slopes(true)},
      {"mu/mu0", by_first(product_of_slopes(false))},
      {"nu/nu0", by_first(product_of_slopes(true))},
      {"r", of_family("int", {{{false, false, 0}, 1}, {{false, false, 1}, 0}})},
      {"alpha", of_family("alpha", {})},
      {"lifting", of_family("lifting", {})},
  };
  return names;
}

constexpr std::array<std::pair<std::string_view, int>, 4> factor_suffixes{
    {{"*sqrt2", 1}, {"/sqrt2", -1}, {"*2", 2}, {"/2", -2}}};

/// Plain letters for Greek ones and typographic signs, without blanks.
std::string plain_letters(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 12> signs{
      {{"φ", "phi"},
       {"ϕ", "phi"},
       {"ψ", "psi"},
       {"μ", "mu"},
       {"ν", "nu"},
       {"α", "alpha"},
       {"′", "'"},
       {"″", "''"},
       {"’", "'"},
       {"√2", "sqrt2"},
       {"−", "-"},
       {"∫", "int"}}};
  std::string result;
  while (!text.empty()) {
    const auto sign = std::find_if(signs.begin(), signs.end(),
                                   [&](const auto& s) { return text.starts_with(s.first); });
    if (sign != signs.end()) {
      result += sign->second;
      text.remove_prefix(sign->first.size());
    } else {
      result += text.front();
      text.remove_prefix(1);
    }
  }
  return result;
}

/// Recursive descent over the grammar of quantity.hpp.
class Parser {
 public:
  explicit Parser(std::string_view text) : original_(text), text_(plain_letters(text)) {}

  Quantity parse() {
    const bool negated = take("-");
    Quantity result = parse_family();
    result.negated = negated;
    while (parse_suffix(result)) {
    }
    if (!rest().empty()) refuse("a suffix such as *sqrt2 or /first, or the end");
    return result;
  }

 private:
  std::string_view rest() {
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
    return std::string_view(text_).substr(place_);
  }

  bool take(std::string_view token) {
    if (!rest().starts_with(token)) return false;
    place_ += token.size();
    return true;
  }

  [[noreturn]] void refuse(std::string_view expected) {
    rest();
    throw std::invalid_argument(
        fmt::format("the quantity {} is not understood at column {}: expected {}",
                    excerpt(original_), place_ + 1, expected));
  }

  void expect(std::string_view token) {
    if (!take(token)) refuse(fmt::format("'{}'", token));
  }

  /// A name that letters or digits do not continue.
  bool take_word(std::string_view word) {
    const std::string_view text = rest();
    if (!text.starts_with(word)) return false;
    const char next = text.size() > word.size() ? text[word.size()] : ' ';
    const bool goes_on = is_digit(next) || (next >= 'a' && next <= 'z') || next == '_';
    if (goes_on && word.back() != '\'' && word.back() != ')') return false;
    place_ += word.size();
    return true;
  }

  Quantity parse_family() {
    if (take_word("int")) return parse_integral();
    for (const std::string_view name : {"moment", "sobolev", "holder"}) {
      if (take_word(name)) return parse_bracketed(name);
    }
    if (rest().starts_with("dual(p")) return of_family("value", {{parse_function(), 0}});
    const Quantity* longest = nullptr;
    std::size_t length = 0;
    for (const auto& [name, quantity] : short_names()) {
      const std::size_t before = place_;
      if (name.size() > length && take_word(name)) {
        longest = &quantity;
        length = name.size();
      }
      place_ = before;
    }
    if (longest != nullptr) {
      rest();
      place_ += length;
      return *longest;
    }
    if (rest().starts_with("phi") || rest().starts_with("psi")) {
      return of_family("value", {{parse_function(), 0}});
    }
    refuse("h, g, alpha, mu, nu, r, int(..), phi, psi, moment(..), lifting or another");
  }

  Quantity parse_bracketed(std::string_view name) {
    expect("(");
    const BasisFunction f = parse_function();
    expect(")");
    return of_family(name, {{f, 0}});
  }

  int parse_order() {
    const std::string_view text = rest();
    int order = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), order);
    if (error != std::errc() || order < 0 || order > certified::highest_derivative) {
      refuse(fmt::format("an order of a derivative from 0 to {}", certified::highest_derivative));
    }
    place_ += static_cast<std::size_t>(end - text.data());
    return order;
  }

  BasisFunction parse_function() {
    const bool dual = take("dual(");
    BasisFunction f;
    if (take("psi")) {
      f.wavelet = true;
    } else if (!take("phi")) {
      refuse("phi or psi");
    }
    f.dual = take("~") || dual;
    while (take("'")) ++f.derivative;
    if (take("^(")) {
      f.derivative = parse_order();
      expect(")");
    }
    if (f.derivative > certified::highest_derivative) {
      refuse(fmt::format("at most {} primes", certified::highest_derivative));
    }
    if (dual) expect(")");
    return f;
  }

  /// The letter of a shift, numbered in order of appearance; 0 without one.
  int parse_shift(std::string& letters) {
    if (!take("(")) return 0;
    const std::string_view text = rest();
    if (text.empty() || text.front() < 'a' || text.front() > 'z') refuse("a letter such as l");
    const char letter = text.front();
    if (letters.find(letter) != std::string::npos) refuse("a letter that is not used twice");
    letters += letter;
    ++place_;
    expect(")");
    return static_cast<int>(letters.size());
  }

  Quantity parse_integral() {
    constexpr std::size_t most = 3;
    expect("(");
    std::vector<Factor> factors;
    std::string letters;
    do {
      if (factors.size() == most) refuse("')': integrals have two or three factors");
      const BasisFunction f = parse_function();
      factors.push_back({f, parse_shift(letters)});
      take(",");
    } while (!take(")"));
    if (factors.size() < 2) refuse("two or three factors in an integral");
    if (letters.empty()) {
      for (std::size_t i = 1; i < factors.size(); ++i) factors[i].shift = static_cast<int>(i);
    } else if (letters.size() != factors.size() - 1) {
      refuse("shifts of all factors but one");
    }
    return of_family("int", std::move(factors));
  }

  bool parse_suffix(Quantity& quantity) {
    for (const auto& [suffix, power] : factor_suffixes) {
      if (!take(suffix)) continue;
      quantity.half_powers += power;
      return true;
    }
    if (quantity.divided_by_first || !take("/first")) return false;
    quantity.divided_by_first = true;
    return true;
  }

  std::string_view original_;
  std::string text_;
  std::size_t place_ = 0;
};

std::string integral_text(const std::vector<Factor>& factors) {
  std::string text;
  constexpr std::string_view letters = " lm";
  const bool plain_order =
      factors.front().shift == 0 && (factors.size() == 2 || factors[1].shift < factors[2].shift);
  for (const Factor& factor : factors) {
    text += (text.empty() ? "" : ", ") + certified::name_of(factor.function);
    if (!plain_order && factor.shift > 0) {
      text += fmt::format("({})", letters[static_cast<std::size_t>(factor.shift)]);
    }
  }
  return "int(" + text + ")";
}

std::string bare_text(const Quantity& quantity) {
  for (const auto& [name, known] : short_names()) {
    if (known == quantity) return std::string(name);
  }
  const std::string_view family = quantity.family->name;
  if (family == "int") return integral_text(quantity.factors);
  const std::string function = certified::name_of(quantity.factors.front().function);
  return family == "value" ? function : fmt::format("{}({})", family, function);
}

}  // namespace

Quantity Quantity::bare() const { return {family, factors, 0, false, false}; }

Quantity parse_quantity(std::string_view text) { return Parser(text).parse(); }

std::string factor_text(int half_powers) {
  std::string text;
  for (; half_powers >= 2; half_powers -= 2) text += "*2";
  for (; half_powers <= -2; half_powers += 2) text += "/2";
  if (half_powers != 0) text += half_powers > 0 ? "*sqrt2" : "/sqrt2";
  return text;
}

std::string to_string(const Quantity& quantity) {
  std::string text = quantity.negated ? "-" : "";
  Quantity normalized = quantity.bare();
  normalized.divided_by_first = quantity.divided_by_first;
  const bool has_short_name =
      std::any_of(short_names().begin(), short_names().end(),
                  [&](const auto& entry) { return entry.second == normalized; });
  text += bare_text(has_short_name ? normalized : quantity.bare());
  if (quantity.divided_by_first && !has_short_name) text += "/first";
  return text + factor_text(quantity.half_powers);
}

bool is_taps(const Quantity& quantity) {
  return quantity.bare() == Quantity::taps && !quantity.negated && !quantity.divided_by_first;
}

std::string quantities_help() {
  std::string text;
  for (const QuantityFamily& family : quantity_families()) {
    text += fmt::format("  {:<16} {}\n", family.example, family.meaning);
  }
  return text;
}

}  // namespace wavecurve::verification
