#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "wavecurve/io/drawings/detail/svg/warnings.hpp"
#include "wavecurve/io/drawings/detail/svg/xml_element.hpp"

namespace wavecurve::io {

/// Values by property.
using Properties = std::map<std::string, std::string, std::less<>>;

/// The rules of CSS that <style> elements give. Selectors are names, .classes, #ids and *, their
/// compounds, and these joined as descendants or children; everything else is named in a warning
/// and skipped.
class StyleSheet {
 public:
  void add(std::string_view css, Warnings& warnings);

  /// The declarations that win for an element: its presentation attributes, overruled by the rules
  /// in the order of their specificity, by its attribute `style`, and by what is !important.
  Properties cascade(const XmlElement& element) const;

 private:
  struct Compound {
    std::string name, id;
    std::vector<std::string> classes;
    bool child = false;  ///< of the compound before: else any descendant
    bool matches(const XmlElement& element) const;
  };
  struct Declaration {
    std::string property, value;
    bool important = false;
  };
  struct Rule {
    std::vector<Compound> selector;
    std::vector<Declaration> declarations;
    std::array<int, 3> specificity() const;
  };

  static std::vector<Declaration> declarations_of(std::string_view text);
  static bool parse_selector(std::string_view text, std::vector<Compound>& selector);
  static bool matches(const std::vector<Compound>& selector, const XmlElement& element);
  void add_rule(std::string_view selectors, std::string_view block, Warnings& warnings);

  std::vector<Rule> rules_;  ///< the more specific, then the later one, last
};

}  // namespace wavecurve::io
