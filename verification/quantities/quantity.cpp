#include "verification/quantities/quantity.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "verification/quantities/grammar_reader.hpp"
#include "verification/quantities/integral_expression.hpp"
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
  };
  return names;
}

constexpr std::array<std::pair<std::string_view, int>, 4> factor_suffixes{
    {{"*sqrt2", 1}, {"/sqrt2", -1}, {"*2", 2}, {"/2", -2}}};

/// Whether its name and one function in brackets say it, as its example has it: "moment(psi)".
bool has_brackets(const QuantityFamily& family) {
  return family.most_factors == 1 && family.example.starts_with(fmt::format("{}(", family.name));
}

/// Recursive descent over the grammar of quantity.hpp.
class Parser {
 public:
  explicit Parser(std::string_view text) : reader_("quantity", text) {}

  Quantity parse() {
    const bool negated = reader_.take("-");
    Quantity result = parse_family();
    result.negated = negated;
    if (result.family->name == "int") parse_range(result);
    while (parse_suffix(result)) {
    }
    if (!reader_.rest().empty()) reader_.refuse("a suffix such as *sqrt2 or /first, or the end");
    return result;
  }

 private:
  Quantity parse_family() {
    if (reader_.take_word("int")) return parse_integral();
    for (const QuantityFamily& family : quantity_families()) {
      if (family.most_factors == 0 && reader_.take_word(family.name)) {
        return of_family(family.name, {});
      }
      if (has_brackets(family) && reader_.take_word(family.name)) {
        return parse_bracketed(family.name);
      }
    }
    if (reader_.rest().starts_with("dual(p"))
      return of_family("value", {{reader_.take_function(), 0}});
    const Quantity* longest = nullptr;
    std::size_t length = 0;
    for (const auto& [name, quantity] : short_names()) {
      const std::size_t before = reader_.place();
      if (name.size() > length && reader_.take_word(name)) {
        longest = &quantity;
        length = name.size();
      }
      reader_.go_back(before);
    }
    if (longest != nullptr) {
      reader_.rest();
      reader_.skip(length);
      return *longest;
    }
    if (reader_.rest().starts_with("phi") || reader_.rest().starts_with("psi")) {
      return of_family("value", {{reader_.take_function(), 0}});
    }
    reader_.refuse("h, g, alpha, mu, nu, r, int(..), phi, psi, moment(..), lifting or another");
  }

  Quantity parse_bracketed(std::string_view name) {
    reader_.expect("(");
    const BasisFunction f = reader_.take_function();
    reader_.expect(")");
    return of_family(name, {{f, 0}});
  }

  /// The letter of a shift, numbered in order of appearance; 0 without one.
  int parse_shift(std::string& letters) {
    if (!reader_.take("(")) return 0;
    reader_.take_letter(letters);
    reader_.expect(")");
    return static_cast<int>(letters.size());
  }

  Quantity parse_integral() {
    constexpr std::size_t most = most_factors;
    reader_.expect("(");
    std::vector<Factor> factors;
    std::string letters;
    do {
      if (factors.size() == most) reader_.refuse("')': integrals have at most four factors");
      const BasisFunction f = reader_.take_function();
      factors.push_back({f, parse_shift(letters)});
      reader_.take(",");
    } while (!reader_.take(")"));
    if (factors.size() < 2) reader_.refuse("two to four factors in an integral");
    if (letters.empty()) {
      for (std::size_t i = 1; i < factors.size(); ++i) factors[i].shift = static_cast<int>(i);
    }
    return of_family("int", std::move(factors));
  }

  /// [on [a,b]], and whether the factors suit the range.
  void parse_range(Quantity& quantity) {
    const bool has_range = reader_.take_word("on");
    if (has_range) take_interval(quantity);
    const std::size_t factors = quantity.factors.size();
    const auto letters = static_cast<std::size_t>(
        std::ranges::count_if(quantity.factors, [](const Factor& f) { return f.shift > 0; }));
    if (!has_range && letters != factors - 1) reader_.refuse("shifts of all factors but one");
    if (has_range && factors == most_factors) {
      reader_.refuse("at most three factors in an integral over an interval");
    }
    if (quantity.up_to_x && letters == factors) {
      reader_.refuse("a factor without a letter, beyond whose support the integral is constant");
    }
  }

  void take_interval(Quantity& quantity) {
    reader_.expect("[");
    const std::string_view rest = reader_.rest();
    const std::size_t length = rest.find(']');
    if (length == std::string_view::npos) reader_.refuse("an interval such as [0,1]");
    const std::string text(rest.substr(0, length));
    quantity.up_to_x = is_up_to_x(text);
    if (!quantity.up_to_x) quantity.interval = parse_interval(text);
    reader_.skip(length);
    reader_.expect("]");
  }

  bool parse_suffix(Quantity& quantity) {
    for (const auto& [suffix, power] : factor_suffixes) {
      if (!reader_.take(suffix)) continue;
      quantity.half_powers += power;
      return true;
    }
    if (quantity.divided_by_first || !reader_.take("/first")) return false;
    quantity.divided_by_first = true;
    return true;
  }

  GrammarReader reader_;
};

std::string range_text(const Quantity& quantity) {
  if (quantity.up_to_x) return " on [0,x]";
  return quantity.interval ? " on [" + to_string(*quantity.interval) + "]" : "";
}

std::string integral_text(const std::vector<Factor>& factors) {
  std::string text;
  constexpr std::string_view letters = " lmn";
  bool plain_order = true;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    plain_order &= factors[i].shift == static_cast<int>(i);
  }
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
  if (quantity.factors.empty()) return std::string(family);
  if (family == "int") return integral_text(quantity.factors) + range_text(quantity);
  const std::string function = certified::name_of(quantity.factors.front().function);
  return family == "value" ? function : fmt::format("{}({})", family, function);
}

}  // namespace

int Quantity::index_count() const {
  int letters = 0;
  for (const Factor& factor : factors) letters = std::max(letters, factor.shift);
  return family->name == "int" ? letters + (up_to_x ? 1 : 0) : 1;
}

Quantity Quantity::bare() const { return {family, factors, 0, false, false, interval, up_to_x}; }

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
