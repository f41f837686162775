#include "wavecurve/io/drawings/detail/svg/xml_element.hpp"

#include <algorithm>
#include <cstring>
#include <exception>
#include <libxml/SAX2.h>
#include <libxml/parserInternals.h>
#include <new>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/io/drawings/detail/svg/xml_entities.hpp"

namespace wavecurve::io {

namespace {

/// Builds the tree while the parser runs. The parser is C: no exception may pass through it, so what
/// is thrown is kept (see `told`).
struct TreeBuilder {
  xmlParserCtxtPtr parser = nullptr;
  std::unique_ptr<XmlElement> root;
  std::vector<XmlElement*> open;  // the elements that have not ended, each in the one before
  int elements = 0, defaults = 0;
  std::exception_ptr defect;

  [[noreturn]] void refuse(const std::string& what) const {
    throw std::invalid_argument(fmt::format("line {}: {}", line(), what));
  }
  int line() const { return parser->input ? parser->input->line : 0; }
};

/// Lets the builder that the parser passes on act, until anything is thrown.
template <typename Action>
void told(void* context, const Action& action) noexcept {
  auto& tree = *static_cast<TreeBuilder*>(context);
  if (tree.defect) return;
  try {
    action(tree);
  } catch (...) {
    tree.defect = std::current_exception();
    xmlStopParser(tree.parser);
  }
}

std::string text_of(const xmlChar* text) {
  return text ? reinterpret_cast<const char*>(text) : std::string();
}

/// How many attributes that their elements do not have, but the document type gives them, there may be.
constexpr int most_defaults = 1'000'000;

constexpr std::string_view inkscape = "http://www.inkscape.org/namespaces/inkscape";

bool is_svg(const xmlChar* uri) { return !uri || text_of(uri) == "http://www.w3.org/2000/svg"; }

/// libxml2 gives an attribute as five pointers: name, prefix, namespace, begin and end of the
/// value. A prefix that is not declared has no namespace, but xlink is meant as it is usual.
void add_attributes(XmlElement& element, int count, const xmlChar** attributes) {
  for (int i = 0; i < count; ++i, attributes += 5) {
    const std::string prefix = text_of(attributes[1]), space = text_of(attributes[2]);
    const bool link =
        space == "http://www.w3.org/1999/xlink" || (space.empty() && prefix == "xlink");
    const bool label = space == inkscape && text_of(attributes[0]) == "label";
    if ((!space.empty() || !prefix.empty()) && !link && !label) continue;
    std::string value(reinterpret_cast<const char*>(attributes[3]),
                      reinterpret_cast<const char*>(attributes[4]));
    if (label) {
      element.attributes.insert_or_assign("inkscape:label", std::move(value));
    } else if (link) {
      element.attributes.try_emplace(text_of(attributes[0]), std::move(value));
    } else {
      element.attributes.insert_or_assign(text_of(attributes[0]), std::move(value));
    }
  }
}

void start_element(void* context, const xmlChar* name, const xmlChar*, const xmlChar* uri, int,
                   const xmlChar**, int attribute_count, int default_count,
                   const xmlChar** attributes) {
  told(context, [&](TreeBuilder& tree) {
    if ((tree.defaults += default_count) > most_defaults) {
      tree.refuse(
          fmt::format("more than {} attributes that the document type gives", most_defaults));
    }
    if (tree.open.size() == deepest_nesting) {
      tree.refuse(fmt::format("more than {} elements in each other", deepest_nesting));
    }
    if (++tree.elements > most_elements) {
      tree.refuse(fmt::format("more than {} elements", most_elements));
    }
    auto element = std::make_unique<XmlElement>();
    if (is_svg(uri)) element->name = text_of(name);
    element->line = tree.line();
    if (!tree.open.empty()) element->parent = tree.open.back();
    add_attributes(*element, attribute_count, attributes);
    XmlElement* const added = element.get();
    (tree.open.empty() ? tree.root : tree.open.back()->children.emplace_back()) =
        std::move(element);
    tree.open.push_back(added);
  });
}

void end_element(void* context, const xmlChar*, const xmlChar*, const xmlChar*) {
  told(context, [](TreeBuilder& tree) { tree.open.pop_back(); });
}

void add_text(void* context, const xmlChar* text, int length) {
  told(context, [&](TreeBuilder& tree) {
    if (tree.open.empty()) return;
    tree.open.back()->text.append(reinterpret_cast<const char*>(text),
                                  static_cast<std::size_t>(length));
  });
}

/// What with_entities() has left, as in a document of other bytes than ASCII's.
void refuse_entity(void* context, const xmlChar* name, int, const xmlChar*, const xmlChar*,
                   xmlChar*) {
  told(context, [&](const TreeBuilder& tree) {
    tree.refuse(fmt::format("declares the entity {} in a way that is not read", text_of(name)));
  });
}

/// The parser itself adds the values that a declaration gives to attributes.
void free_values(void*, const xmlChar*, const xmlChar*, int, int, const xmlChar*,
                 xmlEnumerationPtr values) {
  xmlFreeEnumeration(values);
}

xmlSAXHandler handler() {
  xmlSAXHandler sax = {};
  sax.initialized = XML_SAX2_MAGIC;
  sax.startElementNs = start_element;
  sax.endElementNs = end_element;
  sax.characters = add_text;
  sax.cdataBlock = add_text;
  sax.entityDecl = refuse_entity;
  sax.attributeDecl = free_values;
  return sax;
}

/// Refuses elements with too many attributes before libxml2 reads them. Outside of comments, of what begins
/// with <! or <?, and of closing tags, an attribute ends with the second quote of its kind.
void check_attributes(std::string_view bytes) {
  const auto skip_behind = [&](std::size_t from, std::string_view end) {
    return std::min(bytes.find(end, from), bytes.size());
  };
  for (std::size_t i = 0; (i = bytes.find('<', i)) != std::string_view::npos;) {
    const std::string_view rest = bytes.substr(i);
    if (rest.starts_with("<!--")) {
      i = skip_behind(i, "-->");
    } else if (rest.starts_with("<![CDATA[")) {
      i = skip_behind(i, "]]>");
    } else if (rest.starts_with("<!") || rest.starts_with("<?")) {
      i = skip_behind(i, ">");
    } else {
      int attributes = 0;
      for (++i; i < bytes.size() && bytes[i] != '>'; ++i) {
        if (bytes[i] != '"' && bytes[i] != '\'') continue;
        if (++attributes > most_attributes) {
          throw std::invalid_argument(fmt::format("line {}: an element has more than {} attributes",
                                                  1 + std::ranges::count(bytes.substr(0, i), '\n'),
                                                  most_attributes));
        }
        i = skip_behind(i + 1, bytes.substr(i, 1));
      }
    }
  }
}

std::string error_of(xmlParserCtxtPtr parser) {
  const xmlError* const error = xmlCtxtGetLastError(parser);
  if (error && error->code == XML_ERR_NO_MEMORY) throw std::bad_alloc();
  if (!error || !error->message) return "not XML";
  std::string message = error->message;
  while (!message.empty() && message.back() == '\n') message.pop_back();
  return fmt::format("line {}: not XML: {}", error->line, message);
}

/// libxml2 keeps declared entities in a document even where none is built.
struct FreeParser {
  void operator()(xmlParserCtxtPtr parser) const {
    if (parser->myDoc) xmlFreeDoc(parser->myDoc);
    xmlFreeParserCtxt(parser);
  }
};

}  // namespace

std::string_view XmlElement::attribute(std::string_view key) const {
  const auto found = attributes.find(key);
  return found == attributes.end() ? std::string_view() : found->second;
}

std::unique_ptr<XmlElement> read_xml(std::string_view bytes) {
  if (bytes.empty()) throw std::invalid_argument("not XML: it is empty");
  std::string without_entities;
  if (bytes.find("<!ENTITY") != std::string_view::npos)
    bytes = without_entities = with_entities(bytes);
  check_attributes(bytes);
  static const bool initialized = (xmlInitParser(), true);
  static_cast<void>(initialized);
  const std::unique_ptr<xmlParserCtxt, FreeParser> parser(
      xmlCreateMemoryParserCtxt(bytes.data(), static_cast<int>(bytes.size())));
  if (!parser) throw std::bad_alloc();
  TreeBuilder tree;
  tree.parser = parser.get();
  *parser->sax = handler();
  parser->userData = &tree;
  // HUGE lifts the limit of ten megabytes an attribute; our own limits and refusals replace it.
  xmlCtxtUseOptions(parser.get(),
                    XML_PARSE_NONET | XML_PARSE_HUGE | XML_PARSE_NOERROR | XML_PARSE_NOWARNING);
  xmlParseDocument(parser.get());
  if (tree.defect) std::rethrow_exception(tree.defect);
  if (!parser->wellFormed || !tree.root) throw std::invalid_argument(error_of(parser.get()));
  return std::move(tree.root);
}

}  // namespace wavecurve::io
