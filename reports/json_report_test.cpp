// report.json and the blessed reference are what docs/report-json.md says.
#include "reports/json_report.hpp"

#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/read_file.hpp"

#include "verification/suite/reference.hpp"

namespace wavecurve::reports {
namespace {

using namespace verification;

std::string documentation() {
  return io::read_file(std::filesystem::path(WAVECURVE_SOURCE_DIR) / "docs" / "report-json.md");
}

/// The type of each documented field by its path: "| `claims[].id` | string | ... |".
std::map<std::string, std::string> documented_fields() {
  std::map<std::string, std::string> types;
  std::istringstream lines(documentation());
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `")) continue;
    const auto name_end = line.find('`', 3), type = line.find("| ", name_end) + 2;
    types[line.substr(3, name_end - 3)] = line.substr(type, line.find(' ', type) - type);
  }
  return types;
}

/// The ```json blocks of the page.
std::vector<std::string> documented_examples() {
  std::vector<std::string> examples;
  const std::string page = documentation(), begin = "```json\n";
  for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
    const auto start = at + begin.size();
    examples.push_back(page.substr(start, page.find("```", start) - start));
  }
  return examples;
}

using Fields = std::map<std::string, std::string>;

/// The type of every field within by its path; the keys of "counts" are verdicts.
void collect(const nlohmann::json& json, const std::string& path, Fields& fields) {
  if (!path.empty() && !path.ends_with("[]")) {
    std::string& type = fields[path];
    const std::string found = json.is_number_float() ? "number"
                              : json.is_number()     ? "integer"
                                                     : json.type_name();
    if (type != "number") type = found;
  }
  if (json.is_array()) {
    for (const auto& element : json) collect(element, path + "[]", fields);
  }
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items()) {
    const std::string name = path == "counts" ? "VERDICT" : key;
    collect(value, path.empty() ? name : path + "." + name, fields);
  }
}

/// The first claim is that of the documentation; the second has what that lacks.
Report example() {
  Report report{{}, "2026-01-31T12:00:00Z", "0.1.0", {}};
  const Claim mass{"mass-matrix",
                   "The mass matrix is a multiple of the identity",
                   "Section 3.2",
                   "the mass matrix M = ρI",
                   {}};
  const Finding finding{
      "largest entry of |M - I|: at least {} for the biorthogonal ones of {} families",
      {to_decimals("smallest |M - I| of a biorthogonal family", 0.3333, 2), counted("families", 11),
       to_digits("largest |M - I| of the orthonormal families", 3.1e-15, 1)
           .within(1e-13, "It is made of rounding errors.")}};
  report.results = {
      {mass,
       {ClaimVerdict::depends_on_definition,
        finding,
        "True of the orthonormal families only.",
        {Table{"Largest entry of |M - I|", {"filter", "M - I"}, {{"cdf9.7", "0.33"}}}}}}};
  return report;
}

Report example_with_all_evidence() {
  Report report = example();
  report.results.push_back(report.results.front());
  report.results.back().outcome.evidence = {Paragraph{"Text."}, Chart{"chart", {}, "plot data"},
                                            Picture{"picture", "<svg/>", "A square.", {}}};
  return report;
}

TEST(JsonReport, HasTheDocumentedFieldsAndNoOthers) {
  Fields fields;
  collect(nlohmann::json::parse(to_json(example_with_all_evidence())), "", fields);
  EXPECT_EQ(fields, documented_fields());
}

TEST(JsonReport, IsAsTheExampleShows) {
  const auto examples = documented_examples();
  ASSERT_EQ(examples.size(), 2u);
  EXPECT_EQ(to_json(example()), examples[0]);
}

TEST(JsonReport, TheReferenceIsAsItsExampleShows) {
  const auto examples = documented_examples();
  ASSERT_EQ(examples.size(), 2u);
  const auto file = std::filesystem::temp_directory_path() /
                    ("wavecurve_json_report_" + std::to_string(getpid()) + ".json");
  write_reference(file, example().results, false);
  EXPECT_EQ(io::read_file(file), examples[1]);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace wavecurve::reports
