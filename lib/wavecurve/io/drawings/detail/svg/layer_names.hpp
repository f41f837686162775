#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "wavecurve/io/drawings/detail/svg/svg_style.hpp"

namespace wavecurve::io {

/// Gives layers their ids, each once.
class LayerNames {
 public:
  explicit LayerNames(const ElementIndex& elements) : elements_(elements) {}

  struct Name {
    std::string text;
    bool given = false;  ///< by the file: else made up, or that of an element that keeps it
  };

  /// What the layer of a shape is to be called: as the <use> for which it is drawn directly, as its
  /// inkscape:label says, its id (but the label of its group, where the id only numbers paths, as path12), or its
  /// element and number. A copy does not take the name of an element that is drawn in its place.
  Name name_of(const XmlElement& shape, std::string_view use_id, bool is_copy);

  /// A number is added to what is taken; what is made up is no id of the file either.
  std::string unique(const Name& name);

 private:
  const ElementIndex& elements_;
  std::map<std::string, int, std::less<>> shapes_of_name_, copies_;
  std::set<std::string> ids_;
};

}  // namespace wavecurve::io
