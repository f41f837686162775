#pragma once

#include <string>
#include <string_view>

#include "wavecurve/io/drawings/detail/svg/xml_element.hpp"

namespace wavecurve::io {

/// What a message calls an element: rect 'a', or rect.
std::string name_of(const XmlElement& element);

/// Whether an element of that name draws nothing where it stands; so does one that is not of SVG.
bool is_never_drawn(std::string_view name);

/// Whether an element is drawn where it stands, and not only where it is used: it lies in no element
/// that is never drawn.
bool is_drawn_in_place(const XmlElement& element);

/// What a viewer draws that knows no language and no extensions.
bool meets_conditions(const XmlElement& element);

/// Whether a length of the element or in it is a share of a window.
bool has_percentages(const XmlElement& element);

}  // namespace wavecurve::io
