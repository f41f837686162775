#include "wavecurve/io/files/detail/xml_escaped.hpp"

#include <gtest/gtest.h>

namespace wavecurve::io {
namespace {

TEST(XmlEscaped, TextStandsBetweenTagsAndInBothKindsOfQuotes) {
  EXPECT_EQ(xml_escaped("a < b & \"c\" > 'd'"), "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
}

TEST(XmlEscaped, OnlyWhatXmlForbidsIsReplaced) {
  EXPECT_EQ(xml_escaped("a\x01\x7f\t\n\u03bc"), "a\uFFFD\uFFFD\t\n\u03bc");
  EXPECT_EQ(xml_escaped("\xff \xEF\xBF\xBF \xC2\x9B \r"), "\uFFFD \uFFFD \uFFFD \uFFFD");
}

}  // namespace
}  // namespace wavecurve::io
