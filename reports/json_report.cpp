#include "reports/json_report.hpp"

#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/json_text.hpp"

#include "verification/suite/claim_value_json.hpp"
#include "verification/suite/reference.hpp"

namespace wavecurve::reports {

namespace {

using Json = nlohmann::ordered_json;
using namespace verification;

Json json_of(const Table& table) {
  return {{"caption", table.caption}, {"columns", table.columns}, {"rows", table.rows}};
}

struct EvidenceToJson {
  Json operator()(const Paragraph& paragraph) const {
    return {{"kind", "paragraph"}, {"text", paragraph.text}};
  }
  Json operator()(const Table& table) const {
    return {{"kind", "table"}, {"table", json_of(table)}};
  }
  Json operator()(const Chart& chart) const { return figure("chart", chart.id, chart.data); }
  Json operator()(const Picture& picture) const {
    Json json = figure("picture", picture.id, picture.data);
    json["alternative_text"] = picture.alternative_text;
    return json;
  }

  static Json figure(const char* kind, const std::string& id, const Table& data) {
    return {
        {"kind", kind}, {"id", id}, {"file", "figures/" + id + ".svg"}, {"table", json_of(data)}};
  }
};

Json json_of(const ClaimResult& result) {
  const auto& [claim, outcome] = result;
  Json evidence = Json::array();
  for (const Evidence& item : outcome.evidence)
    evidence.push_back(std::visit(EvidenceToJson{}, item));
  Json values = Json::array();
  for (const ClaimValue& value : outcome.finding.values) values.push_back(to_json(value));
  return {{"id", claim.id},
          {"title", claim.title},
          {"location", claim.location},
          {"printed", claim.printed},
          {"verdict", to_string(outcome.verdict)},
          {"finding", outcome.finding.sentence},
          {"values", values},
          {"summary", outcome.summary},
          {"evidence", evidence}};
}

}  // namespace

std::string to_json(const Report& report) {
  Json json;
  json["schema"] = schema_version;
  json["publication"] = {{"title", report.publication.title},
                         {"authors", report.publication.authors},
                         {"year", report.publication.year},
                         {"dates", report.publication.dates}};
  json["generated"] = report.generated;
  json["program"] = report.program;
  json["counts"] = Json::object();
  for (const auto& [verdict, count] : count_verdicts(report.results)) {
    json["counts"][std::string(to_string(verdict))] = count;
  }
  json["claims"] = Json::array();
  for (const ClaimResult& result : report.results) json["claims"].push_back(json_of(result));
  // Text from outside may hold bytes that are no UTF-8; they must not cost the report.
  return io::json_text(json, 1) + "\n";
}

}  // namespace wavecurve::reports
