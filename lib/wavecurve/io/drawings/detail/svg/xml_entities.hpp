#pragma once

#include <string>
#include <string_view>

namespace wavecurve::io {

/// Bounds of internal entities: how many a document may declare, how many may lie in each other, and how many
/// references and characters all that is put in for them may come to.
constexpr std::size_t most_entities = 1000, deepest_entity = 16,
                      most_expanded = std::size_t{4} << 20;

/// An XML document with what its internal general entities stand for in their places, and without their declarations,
/// as Adobe Illustrator writes them: <!ENTITY ns_svg "http://www.w3.org/2000/svg">. Lines keep their
/// numbers. What is in comments, CDATA sections and processing instructions stays as it is. Throws
/// std::invalid_argument naming line and entity for one that lies elsewhere, is a parameter entity, refers
/// to itself, or exceeds a bound; nothing outside of the document is read.
std::string with_entities(std::string_view bytes);

}  // namespace wavecurve::io
