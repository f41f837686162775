#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "wavecurve/filters/basis_function.hpp"

namespace wavecurve::verification {

/// Reads what somebody typed, token by token, for the recursive descent over the grammars of
/// quantity.hpp and integral_expression.hpp. Blanks are free; Greek letters and typographic signs
/// are read as their plain names. Columns count the characters of the text as it was typed, from 1.
class GrammarReader {
 public:
  /// `kind` is what a message calls the text: "quantity".
  GrammarReader(std::string_view kind, std::string_view text);

  /// What is left, from the next token on.
  std::string_view rest();
  bool at_end() { return rest().empty(); }
  /// Steps over this token, if it comes next.
  bool take(std::string_view token);
  /// The same for a name that letters or digits do not continue.
  bool take_word(std::string_view word);
  void expect(std::string_view token);
  void skip(std::size_t bytes) { place_ += bytes; }

  /// A whole number from 0 to most; `meaning` is for the message: "an order of a derivative".
  int take_number(std::string_view meaning, int most);
  /// phi or psi, ~ or dual(..), primes or ^(p).
  BasisFunction take_function();
  /// A letter for an index that does not stand among `letters` yet, to which it is added.
  void take_letter(std::string& letters);

  /// Where the reader stands, to go back to.
  std::size_t place() const { return place_; }
  void go_back(std::size_t place) { place_ = place; }

  /// Throws std::invalid_argument: not understood at this column, expected was so and so.
  [[noreturn]] void refuse(std::string_view expected);

 private:
  std::string_view kind_, original_;
  std::string text_;                  ///< in plain letters
  std::vector<std::size_t> columns_;  ///< of each byte of text_, and of its end
  std::size_t place_ = 0;
};

}  // namespace wavecurve::verification
