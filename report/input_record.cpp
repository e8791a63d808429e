#include "report/input_record.h"

#include "report/finding_json.h"
#include "report/read_parts.h"

namespace rad::report {

namespace {

Json optional_point(const std::optional<geom::dvec3>& point) { return point ? point_json(*point) : Json(nullptr); }

// What is drawn of a finding is not in its JSON.
Json drawing_json(const scene::Where& where) {
  Json json;
  json["faces"] = where.face_ids;
  json["places"] = Json::array();
  for (const scene::FaultPlace& place : where.places) {
    Json entry = Json::array({optional_point(place.point)});
    if (place.segment) {
      entry.push_back(point_json((*place.segment)[0]));
      entry.push_back(point_json((*place.segment)[1]));
    }
    json["places"].push_back(std::move(entry));
  }
  return json;
}

void read_drawing(const Json& json, scene::Where& where) {
  where.face_ids = json.at("faces").get<std::vector<scene::FaceId>>();
  for (const Json& entry : json.at("places")) {
    scene::FaultPlace& place = where.places.emplace_back();
    if (!entry.at(0).is_null()) place.point = read_point(entry.at(0));
    if (entry.size() == 3) place.segment = std::array{read_point(entry.at(1)), read_point(entry.at(2))};
  }
}

InputReport input_of(const Json& json) {
  InputReport input = read_input(json.at("input"));
  input.result.refusal = json.at("refusal").get<std::string>();
  for (const Json& id : json.at("checked")) input.result.checked.push_back(&rule_of(id));
  for (const Json& entry : json.at("findings")) {
    read_drawing(entry.at("drawing"), input.result.findings.emplace_back(read_finding(entry)).where);
  }
  for (const Json& lap : json.at("timings")) {
    input.result.timings.emplace_back(lap.at(0).get<std::string>(), lap.at(1).get<double>());
  }
  return input;
}

}  // namespace

std::string record_of(const InputReport& input) {
  Json json;
  json["input"] = input_json(input);
  json["refusal"] = input.result.refusal;
  json["checked"] = Json::array();
  for (const validate::Rule* rule : input.result.checked) json["checked"].push_back(rule->id);
  json["findings"] = Json::array();
  for (const scene::Finding& finding : input.result.findings) {
    Json& entry = json["findings"].emplace_back(finding_json(finding, 0, input.metres_per_unit));
    entry["drawing"] = drawing_json(finding.where);
  }
  json["timings"] = Json::array();
  for (const auto& [step, seconds] : input.result.timings) json["timings"].push_back(Json::array({step, seconds}));
  std::string bytes;
  Json::to_cbor(json, bytes);
  return bytes;
}

std::optional<InputReport> input_of_record(std::string_view bytes) {
  try {
    return input_of(Json::from_cbor(bytes.begin(), bytes.end()));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace rad::report
