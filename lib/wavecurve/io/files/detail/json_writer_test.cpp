#include "wavecurve/io/files/detail/json_writer.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/json_text.hpp"

namespace wavecurve::io {
namespace {

void write(JsonWriter& writer, const nlohmann::ordered_json& part) {
  if (part.is_object() || part.is_array()) {
    writer.open(part.is_object() ? '{' : '[');
    for (const auto& item : part.items()) {
      if (part.is_object()) writer.key(item.key());
      write(writer, item.value());
    }
    writer.close(part.is_object() ? '}' : ']');
  } else if (part.is_number_float()) {
    writer.value(part.get<double>());
  } else if (part.is_number()) {
    writer.value(part.get<long long>());
  } else if (part.is_string()) {
    writer.value(std::string_view(part.get_ref<const std::string&>()));
  } else {
    writer.null();
  }
}

std::string written(const nlohmann::ordered_json& document, int indent) {
  JsonWriter writer(indent);
  write(writer, document);
  return std::move(writer).text();
}

TEST(JsonWriter, WritesWhatTheDocumentAsAWholeWouldBe) {
  const nlohmann::ordered_json document = {
      {"name", "a \"b\" \\ \n \x01 \x7f ü"},
      {"empty", nlohmann::ordered_json::object()},
      {"list",
       {1.5, -2, nullptr, nlohmann::ordered_json::array(), {{"deep", {0.0, 100.0, 1e-300}}}}},
      {"last", 9007199254740993}};
  for (const int indent : {-1, 0, 2, 4}) {
    EXPECT_EQ(written(document, indent), json_text(document, indent)) << indent;
  }
}

TEST(JsonWriter, DoublesAreReadBackExactly) {
  for (const double value : {0.1, 1.0 / 3, 1e-5, 1e15, 1e16, 1e17, 5e-324, 1.7976931348623157e308,
                             123456789012345680.0, -0.0}) {
    const auto read = nlohmann::json::parse(written(value, -1));
    EXPECT_TRUE(read.is_number_float()) << value;
    EXPECT_EQ(read.get<double>(), value);
    EXPECT_EQ(std::signbit(read.get<double>()), std::signbit(value));
  }
  EXPECT_EQ(written(std::numeric_limits<double>::infinity(), -1), "null");
  EXPECT_EQ(written(std::nan(""), -1), "null");
}

}  // namespace
}  // namespace wavecurve::io
