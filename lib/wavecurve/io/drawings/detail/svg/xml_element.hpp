#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace wavecurve::io {

/// An element of an XML document.
struct XmlElement {
  std::string name;  ///< without prefix; empty for elements that are not of SVG
  std::map<std::string, std::string, std::less<>>
      attributes;    ///< xlink:href is href; of other prefixes inkscape:label only
  std::string text;  ///< of the element itself
  int line = 0;
  const XmlElement* parent = nullptr;
  std::vector<std::unique_ptr<XmlElement>> children;

  /// The value of an attribute, or an empty text.
  std::string_view attribute(std::string_view key) const;
};

/// How many elements may lie in each other, how many there may be, and how many attributes each may have
/// (libxml2 compares every two of them).
constexpr int deepest_nesting = 256, most_elements = 1'000'000, most_attributes = 10'000;

/// The tree of a document. Nothing outside of it is read; internal entities are, within their bounds
/// (xml_entities.hpp), and so are the attributes that a document type gives to elements. Throws
/// std::invalid_argument naming the line of what is not XML, of an entity that is refused, or of an
/// element too many, too deep, or with too many attributes.
std::unique_ptr<XmlElement> read_xml(std::string_view bytes);

}  // namespace wavecurve::io
