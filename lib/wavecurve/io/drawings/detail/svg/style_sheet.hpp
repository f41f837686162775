#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "wavecurve/io/drawings/detail/svg/warnings.hpp"
#include "wavecurve/io/drawings/detail/svg/xml_element.hpp"

namespace wavecurve::io {

/// Values by property.
using Properties = std::map<std::string, std::string, std::less<>>;

/// The rules of CSS that <style> elements give. Selectors are names, .classes, #ids, *, [attributes] of any
/// comparison, :first-child, :last-child and :not() of these, their compounds, and compounds joined as
/// descendants or children; everything else is named in a warning and skipped.
class StyleSheet {
 public:
  void add(std::string_view css, Warnings& warnings);

  /// The declarations that win for an element: its presentation attributes, overruled by the rules
  /// in the order of their specificity, by its attribute `style`, and by what is !important.
  /// Throws std::invalid_argument if all calls together take too long: rules that are tried,
  /// elements that a selector looks at, and declarations are counted, most_steps at most.
  Properties cascade(const XmlElement& element) const;

  static constexpr std::size_t most_steps = 100'000'000;

 private:
  /// [name], or [name=value] with the comparison before the sign = (0 of none).
  struct AttributeTest {
    std::string name, value;
    bool has_value = false;
    char comparison = 0;
    bool matches(const XmlElement& element) const;
  };
  struct Compound {
    std::string name, id;
    std::vector<std::string> classes;
    std::vector<AttributeTest> attributes;
    std::vector<Compound> excluded;  ///< by :not()
    bool first_child = false, last_child = false;
    bool child = false;  ///< of the compound before: else any descendant
    bool matches(const XmlElement& element) const;
    void count(std::array<int, 3>& counts) const;
    std::size_t parts() const;
    std::size_t steps(const XmlElement& element) const;  ///< what its attributes take longer
  };
  struct Declaration {
    std::string property, value;
    bool important = false;
  };
  struct Rule {
    std::vector<Compound> selector;
    std::shared_ptr<const std::vector<Declaration>> declarations;  ///< of several selectors
    std::array<int, 3> specificity() const;
  };

  static std::vector<Declaration> declarations_of(std::string_view text);
  static bool parse_selector(std::string_view text, std::vector<Compound>& selector);
  static bool take_compound(std::string_view& text, Compound& compound, bool in_not);
  static bool take_attribute(std::string_view& text, Compound& compound);
  static bool take_pseudo_class(std::string_view& text, Compound& compound, bool in_not);
  bool matches(const std::vector<Compound>& selector, const XmlElement& element) const;
  void take_steps(std::size_t count) const;
  void add_rule(std::string_view selectors, std::string_view block, Warnings& warnings);

  /// The more specific, then the later one, last.
  std::multimap<std::array<int, 3>, Rule> rules_;
  mutable std::size_t steps_ = 0;
};

}  // namespace wavecurve::io
