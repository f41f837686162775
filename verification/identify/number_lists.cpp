#include "verification/identify/number_lists.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "wavecurve/io/files/detail/text.hpp"

#include "verification/prints/number_forms.hpp"
#include "verification/prints/text_encoding.hpp"

namespace wavecurve::verification {

namespace {

bool begins_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool continues_name(char c) { return begins_name(c) || is_digit(c); }

/// A line without what programs and tables say in comments.
std::string_view without_comment(std::string_view line) {
  const std::string_view start = io::trimmed(line);
  for (const std::string_view mark : {"#", "%", "!", "//", "--", "/*", "*", "```"}) {
    if (start.starts_with(mark)) return {};
  }
  for (const std::string_view mark : {"//", " #", " %", " !", "/*"}) {
    if (const auto place = line.find(mark); place != std::string_view::npos) {
      line = line.substr(0, place);
    }
  }
  return line;
}

/// A piece of a line: a number, the beginning of a new list, or the end of one.
struct Token {
  enum Kind { number, name, open, close } kind;
  std::string text;
};

constexpr std::string_view separators = " \t,;&|\"'\\$";
constexpr std::string_view brackets = "[]{}()";

/// Cuts a line into tokens. `comma_is_decimal` keeps commas within numbers.
class Scanner {
 public:
  Scanner(std::string_view line, bool comma_is_decimal)
      : line_(line), comma_is_decimal_(comma_is_decimal) {}

  std::vector<Token> tokens() {
    while (place_ < line_.size()) step();
    return std::move(tokens_);
  }

 private:
  char at(std::size_t place) const { return place < line_.size() ? line_[place] : '\n'; }

  bool is_separator(char c) const {
    return separators.find(c) != std::string_view::npos && !(comma_is_decimal_ && c == ',');
  }

  void step() {
    const char c = line_[place_];
    if (begins_name(c)) {
      read_word();
    } else if (c == '(' && at(place_ + 1) == '/') {  // (/ ... /) of Fortran
      tokens_.push_back({Token::open, "("});
      place_ += 2;
    } else if (c == '/' && at(place_ + 1) == ')') {
      tokens_.push_back({Token::close, ")"});
      place_ += 2;
    } else if (brackets.find(c) != std::string_view::npos) {
      const bool opens = c == '[' || c == '{' || c == '(';
      tokens_.push_back({opens ? Token::open : Token::close, std::string(1, c)});
      ++place_;
    } else if (is_separator(c) || c == '=' || c == ':' || c == '<' || c == '>') {
      ++place_;
    } else {
      read_number();
    }
  }

  /// A name and what belongs to it: h, np.array, real(8), h[8] =, h(0:7) =, c( of R.
  void read_word() {
    const std::size_t begin = place_;
    while (continues_name(at(place_)) || (at(place_) == '.' && begins_name(at(place_ + 1))))
      ++place_;
    const std::string name(line_.substr(begin, place_ - begin));
    skip_subscript();
    std::size_t next = place_;
    while (at(next) == ' ' || at(next) == '\t') ++next;
    const bool is_assigned = at(next) == '=' || (at(next) == ':' && at(next + 1) == '=') ||
                             (at(next) == '<' && at(next + 1) == '-');
    if (is_assigned) {
      tokens_.push_back({Token::name, name});
      place_ = next + 1 + (at(next) == '=' ? 0 : 1);
    } else {
      tokens_.push_back({Token::name, ""});  // a word between numbers is a label
    }
  }

  /// "[8]", "(8)", "(0:7)", "[]": whole numbers that say how many there are.
  void skip_subscript() {
    const char open = at(place_);
    if (open != '[' && open != '(') return;
    std::size_t end = place_ + 1;
    while (is_digit(at(end)) || at(end) == ':' || at(end) == '-' || at(end) == '*') ++end;
    if (at(end) == (open == '[' ? ']' : ')') && end < line_.size()) place_ = end + 1;
  }

  void read_number() {
    const std::size_t begin = place_;
    while (place_ < line_.size()) {
      const char c = line_[place_];
      if (is_separator(c) || c == '=' || c == ']' || c == '}' || c == ')' || c == '<') break;
      if (c == '/' && at(place_ + 1) == ')') break;
      if ((c == '(' || c == '{' || c == '[') && !skip_exponent(c)) break;
      ++place_;
    }
    tokens_.push_back({Token::number, std::string(line_.substr(begin, place_ - begin))});
    if (place_ == begin) ++place_;
  }

  /// 5.3(-3) and 10^{-3}: moves to the bracket's end.
  bool skip_exponent(char open) {
    std::size_t end = place_ + 1;
    while (is_digit(at(end)) || at(end) == '-' || at(end) == '+') ++end;
    if (end == place_ + 1 || at(end) != (open == '(' ? ')' : open == '{' ? '}' : ']')) return false;
    place_ = end;
    return true;
  }

  std::string_view line_;
  bool comma_is_decimal_;
  std::size_t place_ = 0;
  std::vector<Token> tokens_;
};

/// "5.3 * 10^-3" without the blanks.
std::string closed_powers(std::string line) {
  for (std::size_t at = 0; (at = line.find('*', at)) != std::string::npos; ++at) {
    while (at + 1 < line.size() && line[at + 1] == ' ') line.erase(at + 1, 1);
    while (at > 0 && line[at - 1] == ' ') line.erase(--at, 1);
  }
  return line;
}

std::optional<PrintedNumber> number_of(const std::string& text, bool comma_is_decimal) {
  std::string_view digits = text;  // "data h /0.48d0, 0.83d0/" of Fortran
  while (digits.starts_with('/')) digits.remove_prefix(1);
  while (digits.ends_with('/')) digits.remove_suffix(1);
  try {
    return parse_printed_number(digits, comma_is_decimal ? DecimalMark::comma : DecimalMark::point);
  } catch (const std::invalid_argument&) {  // a label
    return std::nullopt;
  }
}

/// "0,4829" but neither "0.4829" nor "1, 2" nor "1,2,3".
bool has_decimal_commas(std::string_view text) {
  bool any = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char before = i > 0 ? text[i - 1] : ' ', behind = i + 1 < text.size() ? text[i + 1] : ' ';
    if (text[i] == '.' && is_digit(behind)) return false;
    if (text[i] != ',') continue;
    if (!is_digit(before) || !is_digit(behind)) return false;
    const auto end = std::min(text.find_first_not_of("0123456789", i + 1), text.size());
    if (end < text.size() && text[end] == ',') return false;
    any = true;
  }
  return any;
}

struct Line {
  std::vector<PrintedNumber> numbers;
};

void require_few(std::size_t count) {
  if (count <= most_listed_numbers) return;
  throw std::invalid_argument("the text has more than " + std::to_string(most_listed_numbers) +
                              " numbers");
}

/// An assignment, or a bracket before a number.
bool contains_literals(const std::vector<std::vector<Token>>& lines) {
  bool is_open = false;
  for (const auto& tokens : lines) {
    for (const Token& token : tokens) {
      if (token.kind == Token::name && !token.text.empty()) return true;
      if (token.kind == Token::number && is_open) return true;
      is_open = token.kind == Token::open;
    }
  }
  return false;
}

/// One list for each literal: a name or an opening bracket begins it.
std::vector<NumberList> lists_of_literals(const std::vector<std::vector<Token>>& lines,
                                          bool comma_is_decimal) {
  std::vector<NumberList> lists(1);
  std::size_t count = 0;
  const auto begin = [&](const std::string& name) {
    if (!lists.back().numbers.empty()) lists.emplace_back();
    if (!name.empty()) lists.back().name = name;
  };
  for (const auto& tokens : lines) {
    for (const Token& token : tokens) {
      if (token.kind == Token::number) {
        if (const auto number = number_of(token.text, comma_is_decimal)) {
          require_few(++count);
          lists.back().numbers.push_back(*number);
        }
      } else if (token.kind == Token::open || !token.text.empty()) {
        if (token.kind != Token::close) begin(token.kind == Token::name ? token.text : "");
      }
    }
  }
  std::erase_if(lists, [](const NumberList& list) { return list.numbers.empty(); });
  return lists;
}

/// h[0] = 0.48; h[1] = 0.83; one number each, of one name, are one list.
std::vector<NumberList> joined(std::vector<NumberList> lists) {
  const bool are_elements =
      lists.size() > 1 && std::all_of(lists.begin(), lists.end(), [&](const NumberList& list) {
        return list.numbers.size() == 1;
      });
  if (!are_elements) return lists;
  std::vector<NumberList> result;
  for (NumberList& list : lists) {
    if (result.empty() || (result.back().name != list.name && !list.name.empty())) {
      result.push_back(std::move(list));
    } else {
      result.back().numbers.push_back(list.numbers.front());
    }
  }
  return result;
}

std::optional<int> whole(const PrintedNumber& number) {
  if (number.is_scientific() || number.is_fraction() || number.decimals() != 0) return std::nullopt;
  const double value = number.to_double();
  if (std::abs(value) > 1e6) return std::nullopt;
  return static_cast<int>(value);
}

/// The first index if the numbers are consecutive integers, and more than one.
std::optional<int> first_of_consecutive(const std::vector<PrintedNumber>& numbers) {
  if (numbers.size() < 2) return std::nullopt;
  const auto first = whole(numbers.front());
  for (std::size_t i = 0; first && i < numbers.size(); ++i) {
    if (whole(numbers[i]) != *first + static_cast<int>(i)) return std::nullopt;
  }
  return first;
}

std::vector<NumberList> lists_of_columns(const std::vector<Line>& lines) {
  std::vector<NumberList> columns(lines.front().numbers.size());
  for (const Line& line : lines) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      columns[c].numbers.push_back(line.numbers[c]);
    }
  }
  if (columns.size() < 2) return columns;
  const auto index = first_of_consecutive(columns.front().numbers);
  if (!index) return columns;
  columns.erase(columns.begin());
  for (NumberList& column : columns) column.first_index = index;
  return columns;
}

/// Columns where all lines have equally many numbers; else the numbers in reading order.
std::vector<NumberList> lists_of_lines(const std::vector<std::vector<Token>>& lines,
                                       bool comma_is_decimal) {
  std::vector<Line> rows;
  std::size_t count = 0;
  for (const auto& tokens : lines) {
    Line row;
    for (const Token& token : tokens) {
      if (token.kind != Token::number) continue;
      if (const auto number = number_of(token.text, comma_is_decimal)) {
        require_few(++count);
        row.numbers.push_back(*number);
      }
    }
    if (!row.numbers.empty()) rows.push_back(std::move(row));
  }
  if (rows.empty()) return {};
  const bool is_table =
      rows.size() > 1 && std::all_of(rows.begin(), rows.end(), [&](const Line& r) {
        return r.numbers.size() == rows.front().numbers.size();
      });
  if (is_table) return lists_of_columns(rows);
  NumberList all;
  for (const Line& row : rows) {
    all.numbers.insert(all.numbers.end(), row.numbers.begin(), row.numbers.end());
  }
  return {std::move(all)};
}

}  // namespace

std::vector<NumberList> read_number_lists(std::string_view text) {
  const std::string utf8 = to_utf8(text);
  std::vector<std::string> lines;
  std::string all;
  for_each_text_line(utf8, [&](std::string_view line, int) {
    lines.push_back(closed_powers(plain_signs(without_comment(line))));
    all += lines.back() + "\n";
  });
  const bool comma_is_decimal = has_decimal_commas(all);
  std::vector<std::vector<Token>> tokens;
  for (const std::string& line : lines) tokens.push_back(Scanner(line, comma_is_decimal).tokens());
  const bool has_literals = contains_literals(tokens);
  std::vector<NumberList> lists = has_literals ? joined(lists_of_literals(tokens, comma_is_decimal))
                                               : lists_of_lines(tokens, comma_is_decimal);
  if (lists.empty()) throw std::invalid_argument("the text has no number");
  for (const NumberList& list : lists) {
    if (list.numbers.size() <= longest_list) continue;
    throw std::invalid_argument("a list has " + std::to_string(list.numbers.size()) +
                                " numbers, but no known column has nearly so many: at most " +
                                std::to_string(longest_list) + " are looked for");
  }
  return lists;
}

}  // namespace wavecurve::verification
