#include "wavecurve/io/drawings/detail/svg/xml_entities.hpp"

#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"

namespace wavecurve::io {
namespace {

std::string refused(const std::string& entities, const std::string& body) {
  return test::refusal([&] { with_entities("<!DOCTYPE svg [\n" + entities + "]>\n" + body); });
}

TEST(XmlEntities, StandInTheirPlaces) {
  EXPECT_EQ(
      with_entities(
          "<!DOCTYPE s [\n<!ENTITY a \"fill:red\">\n<!ENTITY b '&a;;x:\"y\"'\n>]><s t='&b;'>&a;</s>"),
      "<!DOCTYPE s [\n\n\n]><s t='fill:red;x:&quot;y&quot;'>fill:red</s>");
  // If two have one name, the first counts.
  EXPECT_EQ(with_entities("<!ENTITY a '1'><!ENTITY a '2'>&a;"), "1");
  EXPECT_EQ(with_entities("<!ENTITY a '<g/>\n&#38;amp;'><s>&a;</s>"), "\n<s><g/> &amp;</s>");
}

TEST(XmlEntities, OtherTextStaysAsItIs) {
  const std::string texts[] = {"<!-- <!ENTITY % x> &a; -->", "<![CDATA[&a;]]>", "<?x &a; ?>",
                               "&lt;&#65;&b;& &", "<s t=\"<!ENTITY % x>\"/>"};
  for (const std::string& text : texts) {
    EXPECT_EQ(with_entities("<!ENTITY a 'x'><!ENTITY lt 'y'>" + text), text);
  }
}

TEST(XmlEntities, WhatLiesElsewhereIsRefused) {
  EXPECT_EQ(refused("<!ENTITY a SYSTEM 'file:///etc/passwd'>", "&a;"),
            "line 2: declares the entity a, which lies elsewhere and is not read");
  EXPECT_EQ(refused("<!ENTITY a PUBLIC 'x' 'y'>", ""),
            "line 2: declares the entity a, which lies elsewhere and is not read");
  EXPECT_EQ(refused("<!ENTITY % a 'b'>", ""),
            "line 2: declares the parameter entity a; only general ones are read");
}

TEST(XmlEntities, AreBounded) {
  std::string laughs = "<!ENTITY a0 ''>";
  for (int i = 1; i < 12; ++i) {
    laughs += "<!ENTITY a" + std::to_string(i) + " '";
    for (int k = 0; k < 10; ++k) laughs += "&a" + std::to_string(i - 1) + ";";
    laughs += "'>";
  }
  EXPECT_EQ(refused(laughs, "<svg d='&a11;'/>"),
            "line 3: entities stand for more than 4194304 references and characters");
  EXPECT_EQ(refused("<!ENTITY a '&b;'><!ENTITY b '&a;'>", "&a;"),
            "line 3: the entity a lies in itself, or in more than 16 others");
  EXPECT_EQ(refused("<!ENTITY a '" + std::string(1 << 20, 'x') + "'>", "&a;&a;&a;&a;"),
            "line 3: entities stand for more than 4194304 references and characters");
  std::string many;
  for (int i = 0; i < 1001; ++i) many += "<!ENTITY a" + std::to_string(i) + " ''>";
  EXPECT_EQ(refused(many, ""), "line 2: more than 1000 entities");
  EXPECT_EQ(refused("<!ENTITY a x>", ""), "line 2: the entity a has no value in quotes");
  EXPECT_EQ(refused("<!ENTITY", ""), "line 2: the entity ] has no value in quotes");
}

}  // namespace
}  // namespace wavecurve::io
