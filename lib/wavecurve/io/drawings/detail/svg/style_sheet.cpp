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
constexpr std::string_view presentation_attributes[] = {"clip-path",
                                                        "color",
                                                        "display",
                                                        "fill",
                                                        "fill-opacity",
                                                        "fill-rule",
                                                        "filter",
                                                        "marker-end",
                                                        "marker-mid",
                                                        "marker-start",
                                                        "mask",
                                                        "opacity",
                                                        "stop-color",
                                                        "stop-opacity",
                                                        "stroke",
                                                        "stroke-dasharray",
                                                        "stroke-linecap",
                                                        "stroke-linejoin",
                                                        "stroke-miterlimit",
                                                        "stroke-opacity",
                                                        "stroke-width",
                                                        "paint-order",
                                                        "vector-effect",
                                                        "visibility"};

constexpr std::size_t most_classes = 16;  // of one compound

/// A step is what it takes to compare a name; classes are split anew each time.
std::size_t steps_to_match(const XmlElement& element) {
  return 1 + element.attribute("class").size() / 16;
}

}  // namespace

bool StyleSheet::Compound::matches(const XmlElement& element) const {
  if (!name.empty() && name != "*" && name != element.name) return false;
  if (!id.empty() && id != element.attribute("id")) return false;
  if (classes.empty()) return true;
  const auto own = split(element.attribute("class"), " \t\r\n\f");
  return std::all_of(classes.begin(), classes.end(), [&](const std::string& each) {
    return std::find(own.begin(), own.end(), each) != own.end();
  });
}

std::array<int, 3> StyleSheet::Rule::specificity() const {
  std::array<int, 3> counts = {};
  for (const Compound& compound : selector) {
    counts[0] += !compound.id.empty();
    counts[1] += static_cast<int>(compound.classes.size());
    counts[2] += !compound.name.empty() && compound.name != "*";
  }
  return counts;
}

std::vector<StyleSheet::Declaration> StyleSheet::declarations_of(std::string_view text) {
  std::vector<Declaration> declarations;
  for (std::string_view piece : split(text, ";")) {
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
    if (text.front() == '*') {
      compound.name = "*";
      text.remove_prefix(1);
    } else {
      compound.name = take_name(text);
    }
    while (!text.empty() && (text.front() == '.' || text.front() == '#')) {
      const bool is_class = text.front() == '.';
      text.remove_prefix(1);
      std::string name = take_name(text);
      if (name.empty()) return false;
      if (is_class) {
        if (compound.classes.size() == most_classes) return false;
        compound.classes.push_back(std::move(name));
      } else {
        compound.id = std::move(name);
      }
    }
    if (compound.name.empty() && compound.id.empty() && compound.classes.empty()) return false;
    selector.push_back(std::move(compound));
  }
  return !child && !selector.empty();
}

bool StyleSheet::matches(const std::vector<Compound>& selector, const XmlElement& element) const {
  take_steps(steps_to_match(element));
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
  for (std::string_view text : split(selectors, ",")) {
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
  const auto own = declarations_of(element.attribute("style"));
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
