#include "verification/quantities/grammar_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "verification/prints/printed_number.hpp"

namespace wavecurve::verification {

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 12> letter_signs{
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

/// How many characters these bytes are, by those that begin one in UTF-8.
std::size_t characters_of(std::string_view bytes) {
  return static_cast<std::size_t>(std::count_if(bytes.begin(), bytes.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

}  // namespace

GrammarReader::GrammarReader(std::string_view kind, std::string_view text)
    : kind_(kind), original_(text) {
  std::size_t column = 1;
  while (!text.empty()) {
    const auto sign = std::find_if(letter_signs.begin(), letter_signs.end(),
                                   [&](const auto& s) { return text.starts_with(s.first); });
    const bool is_sign = sign != letter_signs.end();
    const std::string_view read = is_sign ? sign->first : text.substr(0, 1);
    const std::string_view plain = is_sign ? sign->second : read;
    text_ += plain;
    columns_.insert(columns_.end(), plain.size(), column);
    column += characters_of(read);
    text.remove_prefix(read.size());
  }
  columns_.push_back(column);
}

std::string_view GrammarReader::rest() {
  while (place_ < text_.size() && text_[place_] == ' ') ++place_;
  return std::string_view(text_).substr(place_);
}

bool GrammarReader::take(std::string_view token) {
  if (!rest().starts_with(token)) return false;
  place_ += token.size();
  return true;
}

bool GrammarReader::take_word(std::string_view word) {
  const std::string_view text = rest();
  if (!text.starts_with(word)) return false;
  const char next = text.size() > word.size() ? text[word.size()] : ' ';
  const bool goes_on = is_digit(next) || (next >= 'a' && next <= 'z') || next == '_';
  if (goes_on && word.back() != '\'' && word.back() != ')') return false;
  place_ += word.size();
  return true;
}

void GrammarReader::expect(std::string_view token) {
  if (!take(token)) refuse(fmt::format("'{}'", token));
}

int GrammarReader::take_number(std::string_view meaning, int most) {
  const std::string_view text = rest();
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number < 0 || number > most) {
    refuse(fmt::format("{} from 0 to {}", meaning, most));
  }
  place_ += static_cast<std::size_t>(end - text.data());
  return number;
}

BasisFunction GrammarReader::take_function() {
  const bool dual = take("dual(");
  BasisFunction f;
  if (take("psi")) {
    f.wavelet = true;
  } else if (!take("phi")) {
    refuse("phi or psi");
  }
  f.dual = take("~") || dual;
  while (take("'")) ++f.derivative;
  if (f.derivative > highest_derivative) {
    refuse(fmt::format("at most {} primes", highest_derivative));
  }
  if (take("^(")) {
    f.derivative = take_number("an order of a derivative", highest_derivative);
    expect(")");
  }
  if (dual) expect(")");
  return f;
}

void GrammarReader::take_letter(std::string& letters) {
  const std::string_view text = rest();
  if (text.empty() || text.front() < 'a' || text.front() > 'z') refuse("a letter such as l");
  const char letter = text.front();
  if (letters.find(letter) != std::string::npos) refuse("a letter that is not used twice");
  letters += letter;
  ++place_;
}

void GrammarReader::refuse(std::string_view expected) {
  rest();
  throw std::invalid_argument(fmt::format("the {} {} is not understood at column {}: expected {}",
                                          kind_, excerpt(original_), columns_[place_], expected));
}

}  // namespace wavecurve::verification
