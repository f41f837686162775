#include "wavecurve/io/drawings/detail/svg/style_sheet.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

std::string without_comments(std::string_view css) {
  std::string result;
  while (!css.empty()) {
    const std::size_t begin = std::min(css.find("/*"), css.size());
    result += css.substr(0, begin);
    const std::size_t end = begin < css.size() ? css.find("*/", begin + 2) : std::string_view::npos;
    css.remove_prefix(end == std::string_view::npos ? css.size() : end + 2);
  }
  return result;
}

/// The position behind the brace that closes the one at `open`.
std::size_t end_of_block(std::string_view css, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < css.size(); ++i) {
    if (css[i] == '{') ++depth;
    if (css[i] == '}' && --depth == 0) return i + 1;
  }
  return css.size();
}

bool is_part_of_name(char c) {
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return letter || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         static_cast<unsigned char>(c) >= 128;
}

/// The name at the begin of the text, which is removed from it.
std::string take_name(std::string_view& text) {
  std::size_t length = 0;
  while (length < text.size() && is_part_of_name(text[length])) ++length;
  std::string name(text.substr(0, length));
  text.remove_prefix(length);
  return name;
}

/// Presentation attributes are those whose names are properties that the reader uses.
constexpr std::string_view presentation_attributes[] = {
    "clip-path",         "clip-rule",      "color",
    "display",           "fill",           "fill-opacity",
    "fill-rule",         "filter",         "marker-end",
    "marker-mid",        "marker-start",   "mask",
    "opacity",           "overflow",       "paint-order",
    "stop-color",        "stop-opacity",   "stroke",
    "stroke-dasharray",  "stroke-linecap", "stroke-linejoin",
    "stroke-miterlimit", "stroke-opacity", "stroke-width",
    "transform-origin",  "vector-effect",  "visibility"};

/// Parts of one compound: classes, attributes, and what they are in :not().
constexpr std::size_t most_parts = 16;

/// Pieces of a text between separators that stand outside of quotes and brackets of any kind.
std::vector<std::string_view> split_outside(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  std::size_t begin = 0;
  int depth = 0;
  char quote = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i == text.size() || (text[i] == separator && depth <= 0 && quote == 0)) {
      if (const auto piece = trimmed(text.substr(begin, i - begin)); !piece.empty()) {
        pieces.push_back(piece);
      }
      begin = i + 1;
    } else if (quote != 0) {
      if (text[i] == quote) quote = 0;
    } else if (text[i] == '"' || text[i] == '\'') {
      quote = text[i];
    } else if (text[i] == '(' || text[i] == '[') {
      ++depth;
    } else if (text[i] == ')' || text[i] == ']') {
      --depth;
    }
  }
  return pieces;
}

/// A step is what it takes to compare a name; classes are split anew each time.
std::size_t steps_to_match(const XmlElement& element) {
  return 1 + element.attribute("class").size() / 16;
}

}  // namespace

bool StyleSheet::AttributeTest::matches(const XmlElement& element) const {
  const auto found = element.attributes.find(name);
  if (found == element.attributes.end()) return false;
  if (!has_value) return true;
  const std::string_view own = found->second;
  const bool empty = value.empty();  // what begins, ends or holds so matches nothing
  switch (comparison) {
    case '^':
      return !empty && own.starts_with(value);
    case '$':
      return !empty && own.ends_with(value);
    case '*':
      return !empty && own.find(value) != std::string_view::npos;
    case '|':
      return own == value || (own.starts_with(value) && own.substr(value.size()).starts_with('-'));
    case '~': {
      const auto words = split(own, " \t\r\n\f");
      return std::find(words.begin(), words.end(), value) != words.end();
    }
    default:
      return own == value;
  }
}

bool StyleSheet::Compound::matches(const XmlElement& element) const {
  if (!name.empty() && name != "*" && name != element.name) return false;
  if (!id.empty() && id != element.attribute("id")) return false;
  const auto* siblings = element.parent ? &element.parent->children : nullptr;
  if (first_child && siblings && siblings->front().get() != &element) return false;
  if (last_child && siblings && siblings->back().get() != &element) return false;
  const auto tests = [&](const AttributeTest& test) { return test.matches(element); };
  if (!std::all_of(attributes.begin(), attributes.end(), tests)) return false;
  const auto applies = [&](const Compound& other) { return other.matches(element); };
  if (std::any_of(excluded.begin(), excluded.end(), applies)) return false;
  if (classes.empty()) return true;
  const auto own = split(element.attribute("class"), " \t\r\n\f");
  return std::all_of(classes.begin(), classes.end(), [&](const std::string& each) {
    return std::find(own.begin(), own.end(), each) != own.end();
  });
}

void StyleSheet::Compound::count(std::array<int, 3>& counts) const {
  counts[0] += !id.empty();
  counts[1] += static_cast<int>(classes.size() + attributes.size()) + first_child + last_child;
  counts[2] += !name.empty() && name != "*";
  for (const Compound& other : excluded) other.count(counts);
}

std::size_t StyleSheet::Compound::parts() const {
  std::size_t parts = classes.size() + attributes.size() + excluded.size();
  for (const Compound& other : excluded) parts += other.parts();
  return parts;
}

std::size_t StyleSheet::Compound::steps(const XmlElement& element) const {
  std::size_t steps = 0;
  for (const AttributeTest& test : attributes) steps += element.attribute(test.name).size() / 16;
  for (const Compound& other : excluded) steps += other.steps(element);
  return steps;
}

std::array<int, 3> StyleSheet::Rule::specificity() const {
  std::array<int, 3> counts = {};
  for (const Compound& compound : selector) compound.count(counts);
  return counts;
}

std::vector<StyleSheet::Declaration> StyleSheet::declarations_of(std::string_view text) {
  std::vector<Declaration> declarations;
  for (std::string_view piece : split_outside(text, ';')) {
    const std::size_t colon = piece.find(':');
    if (colon == std::string_view::npos) continue;
    Declaration declaration{lower_case(trimmed(piece.substr(0, colon))), {}, false};
    std::string_view value = trimmed(piece.substr(colon + 1));
    if (const std::size_t mark = value.rfind('!');
        mark != std::string_view::npos &&
        lower_case(trimmed(value.substr(mark + 1))) == "important") {
      declaration.important = true;
      value = trimmed(value.substr(0, mark));
    }
    declaration.value = value;
    declarations.push_back(std::move(declaration));
  }
  return declarations;
}

bool StyleSheet::parse_selector(std::string_view text, std::vector<Compound>& selector) {
  bool child = false;
  while (!(text = trimmed(text)).empty()) {
    if (text.front() == '>') {
      if (child || selector.empty()) return false;
      child = true;
      text.remove_prefix(1);
      continue;
    }
    Compound compound;
    compound.child = child;
    child = false;
    if (!take_compound(text, compound, false)) return false;
    selector.push_back(std::move(compound));
  }
  return !child && !selector.empty();
}

bool StyleSheet::take_compound(std::string_view& text, Compound& compound, bool in_not) {
  const std::size_t size = text.size();
  if (text.starts_with('*')) {
    compound.name = "*";
    text.remove_prefix(1);
  } else {
    compound.name = take_name(text);
  }
  while (!text.empty() && std::string_view(".#[:").find(text.front()) != std::string_view::npos) {
    const char kind = text.front();
    text.remove_prefix(1);
    if (kind == '[') {
      if (!take_attribute(text, compound)) return false;
    } else if (kind == ':') {
      if (!take_pseudo_class(text, compound, in_not)) return false;
    } else {
      std::string name = take_name(text);
      if (name.empty()) return false;
      if (kind == '.') {
        compound.classes.push_back(std::move(name));
      } else {
        compound.id = std::move(name);
      }
    }
    if (compound.parts() > most_parts) return false;
  }
  return text.size() < size;
}

/// What follows the bracket: name] or name=value], with ~ | ^ $ or * before the sign =.
bool StyleSheet::take_attribute(std::string_view& text, Compound& compound) {
  const std::size_t end = text.find(']');
  if (end == std::string_view::npos) return false;
  std::string_view inner = trimmed(text.substr(0, end));
  text.remove_prefix(end + 1);
  AttributeTest test;
  test.name = take_name(inner);
  inner = trimmed(inner);
  if (test.name.empty()) return false;
  if (!inner.empty()) {
    if (std::string_view("~|^$*").find(inner.front()) != std::string_view::npos) {
      test.comparison = inner.front();
      inner.remove_prefix(1);
    }
    if (!inner.starts_with('=')) return false;
    inner = trimmed(inner.substr(1));
    const bool quoted = inner.size() > 1 && (inner.front() == '"' || inner.front() == '\'') &&
                        inner.back() == inner.front();
    test.value = quoted ? inner.substr(1, inner.size() - 2) : inner;
    test.has_value = true;
  }
  compound.attributes.push_back(std::move(test));
  return true;
}

bool StyleSheet::take_pseudo_class(std::string_view& text, Compound& compound, bool in_not) {
  const std::string name = lower_case(take_name(text));
  if (name == "first-child" || name == "last-child") {
    (name == "first-child" ? compound.first_child : compound.last_child) = true;
    return true;
  }
  if (name != "not" || in_not || !text.starts_with('(')) return false;
  text = trimmed(text.substr(1));
  Compound excluded;
  if (!take_compound(text, excluded, true)) return false;
  text = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (!text.starts_with(')')) return false;
  text.remove_prefix(1);
  compound.excluded.push_back(std::move(excluded));
  return true;
}

bool StyleSheet::matches(const std::vector<Compound>& selector, const XmlElement& element) const {
  take_steps(steps_to_match(element) + selector.back().steps(element));
  if (!selector.back().matches(element)) return false;
  if (selector.size() == 1) return true;
  std::vector<const XmlElement*> line;  // from the root down to the element
  for (const XmlElement* up = &element; up; up = up->parent) line.push_back(up);
  std::reverse(line.begin(), line.end());
  // Which compounds, counted from the first, have been found with the last of them at the element
  // just visited, and at any before.
  std::vector<bool> here(selector.size()), before(selector.size());
  for (const XmlElement* visited : line) {
    take_steps(selector.size() * steps_to_match(*visited));
    std::vector<bool> found(selector.size());
    for (std::size_t i = 0; i < selector.size(); ++i) {
      take_steps(selector[i].steps(*visited));
      const bool led_to = i == 0 || (selector[i].child ? here[i - 1] : before[i - 1]);
      found[i] = led_to && selector[i].matches(*visited);
    }
    here = found;
    for (std::size_t i = 0; i < selector.size(); ++i) before[i] = before[i] || here[i];
  }
  return here.back();
}

void StyleSheet::add(std::string_view css, Warnings& warnings) {
  const std::string text = without_comments(css);
  std::string_view rest = trimmed(text);
  while (!rest.empty()) {
    const std::size_t open = rest.find('{');
    const std::size_t statement = rest.find(';');
    if (rest.front() == '@') {
      warnings.add("the CSS rule {} is not supported",
                   shown(rest.substr(0, rest.find_first_of(" \t\r\n{;"))));
      const bool block = open < statement;
      const std::size_t end =
          block ? end_of_block(rest, open) : std::min(statement, rest.size() - 1) + 1;
      rest = trimmed(rest.substr(end));
      continue;
    }
    if (open == std::string_view::npos) {
      warnings.add("not CSS: '{}'", shown(rest));
      break;
    }
    const std::size_t end = end_of_block(rest, open);
    add_rule(rest.substr(0, open), rest.substr(open + 1, end - open - 1), warnings);
    rest = trimmed(rest.substr(end));
  }
}

void StyleSheet::add_rule(std::string_view selectors, std::string_view block, Warnings& warnings) {
  if (block.ends_with('}')) block.remove_suffix(1);
  const auto declarations =
      std::make_shared<const std::vector<Declaration>>(declarations_of(block));
  for (std::string_view text : split_outside(selectors, ',')) {
    Rule rule{{}, declarations};
    if (parse_selector(text, rule.selector)) {
      const auto specificity = rule.specificity();
      rules_.emplace(specificity, std::move(rule));
    } else {
      warnings.add("the CSS selector '{}' is not supported", shown(text));
    }
  }
}

void StyleSheet::take_steps(std::size_t count) const {
  steps_ += count;
  if (steps_ > most_steps) {
    throw std::invalid_argument(
        fmt::format("more than {} steps to apply the style sheet", most_steps));
  }
}

Properties StyleSheet::cascade(const XmlElement& element) const {
  constexpr std::size_t steps_of_attributes = 50;  // they take as long as so many rules
  take_steps(steps_of_attributes);
  Properties properties;
  for (std::string_view name : presentation_attributes) {
    if (const auto value = trimmed(element.attribute(name)); !value.empty()) {
      properties.emplace(name, value);
    }
  }
  std::vector<const Declaration*> declarations;
  for (const auto& [specificity, rule] : rules_) {
    if (!matches(rule.selector, element)) continue;
    for (const Declaration& declaration : *rule.declarations) {
      take_steps(4 + declaration.value.size() / 64);
      declarations.push_back(&declaration);
    }
  }
  const auto own = declarations_of(without_comments(element.attribute("style")));
  for (const Declaration& declaration : own) declarations.push_back(&declaration);
  for (const bool important : {false, true}) {
    for (const Declaration* declaration : declarations) {
      if (declaration->important == important) {
        properties.insert_or_assign(declaration->property, declaration->value);
      }
    }
  }
  return properties;
}

}  // namespace wavecurve::io
