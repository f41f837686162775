#include "reports/inline_svg.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/core.h>

#include "reports/escape.hpp"

namespace wavecurve::reports {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// The svg element, from its opening tag to its closing one.
std::string_view svg_element(std::string_view document) {
  const std::size_t start = document.find("<svg");
  const std::size_t end = document.rfind("</svg>");
  if (start == std::string_view::npos || end == std::string_view::npos || end < start) {
    throw std::invalid_argument("a picture of the report has no svg element");
  }
  return document.substr(start, end + 6 - start);
}

/// Removes an element that stands first, after blanks.
void drop_leading(std::string_view& body, const std::string& name) {
  std::string_view rest = body.substr(std::min(body.find_first_not_of(blanks), body.size()));
  const std::string opening = fmt::format("<{}>", name), closing = fmt::format("</{}>", name);
  if (!rest.starts_with(opening)) return;
  const std::size_t end = rest.find(closing);
  if (end != std::string_view::npos) body = rest.substr(end + closing.size());
}

struct Attribute {
  std::string_view name, value;  ///< the value without its quotes
  char quote;
};

/// Removes the next attribute of an opening tag; its name is empty when there is none left.
Attribute take_attribute(std::string_view& tag) {
  const std::size_t start = std::min(tag.find_first_not_of(blanks), tag.size());
  tag.remove_prefix(start);
  const std::size_t equals = tag.find('=');
  const std::size_t open = tag.find_first_of("\"'", equals == std::string_view::npos ? 0 : equals);
  if (equals == std::string_view::npos || open == std::string_view::npos) return {{}, {}, '"'};
  const std::size_t close = std::min(tag.find(tag[open], open + 1), tag.size() - 1);
  const Attribute attribute{tag.substr(0, equals), tag.substr(open + 1, close - open - 1),
                            tag[open]};
  tag.remove_prefix(close + 1);
  return attribute;
}

/// The attributes of the opening tag that the page does not set itself. A picture without a view
/// box gets one, so that it can shrink with the page.
std::string kept_attributes(std::string_view tag) {
  std::string kept;
  std::string_view width, height;
  bool has_view_box = false;
  for (Attribute a = take_attribute(tag); !a.name.empty(); a = take_attribute(tag)) {
    if (a.name == "width") width = a.value;
    if (a.name == "height") height = a.value;
    if (a.name == "viewBox") has_view_box = true;
    if (a.name == "role" || a.name == "id" || a.name.starts_with("aria-")) continue;
    kept += fmt::format(" {0}={2}{1}{2}", a.name, a.value, a.quote);
  }
  if (!has_view_box && !width.empty() && !height.empty()) {
    kept += fmt::format(" viewBox=\"0 0 {} {}\"", width, height);
  }
  return kept;
}

/// Inserts the prefix after each place where an id is given or referred to.
std::string prefix_ids(std::string_view svg, const std::string& prefix) {
  static constexpr std::array<std::string_view, 7> markers = {
      " id=\"", " id='", "\tid='", "\nid='", "href=\"#", "href='#", "url(#"};
  std::string result;
  result.reserve(svg.size() + svg.size() / 8);
  for (std::size_t i = 0; i < svg.size();) {
    std::string_view found;
    for (const std::string_view marker : markers) {
      if (svg.substr(i).starts_with(marker)) found = marker;
    }
    if (found.empty()) {
      result += svg[i++];
    } else {
      result += std::string(found) + prefix;
      i += found.size();
    }
  }
  return result;
}

}  // namespace

std::string inline_svg(std::string_view document, const std::string& prefix,
                       const std::string& title, const std::string& description) {
  const std::string_view element = svg_element(document);
  const std::size_t tag_end = element.find('>');
  const std::string_view tag = element.substr(4, tag_end - 4);
  std::string_view body = element.substr(tag_end + 1);
  drop_leading(body, "title");
  drop_leading(body, "desc");
  return "<svg role=\"img\" aria-labelledby=\"" + prefix + "title " + prefix + "desc\"" +
         kept_attributes(tag) + ">\n<title id=\"" + prefix + "title\">" + escape(title) +
         "</title>\n<desc id=\"" + prefix + "desc\">" + escape(description) + "</desc>" +
         prefix_ids(body, prefix);
}

}  // namespace wavecurve::reports
