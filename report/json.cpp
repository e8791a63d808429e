#include "report/json.h"

#include <map>

#include "report/json_parts.h"

namespace rad::report {

namespace {

Json metres_json(const geom::dvec3& point, std::optional<double> metres_per_unit) {
  return metres_per_unit ? point_json(point * *metres_per_unit) : Json(nullptr);
}

Json pair_json(const std::optional<std::array<geom::dvec3, 2>>& pair) {
  if (!pair) return nullptr;
  return Json::array({point_json((*pair)[0]), point_json((*pair)[1])});
}

Json line_json(std::uint64_t line) { return line > 0 ? Json(line) : Json(nullptr); }

Json text_or_null(std::string_view text) { return text.empty() ? Json(nullptr) : Json(text); }

Json faces_json(const std::vector<scene::FaceReference>& faces) {
  Json json = Json::array();
  for (const scene::FaceReference& face : faces) {
    Json entry;
    entry["ref"] = face.ref;
    entry["line"] = line_json(face.line);
    entry["pointer"] = text_or_null(face.pointer);
    json.push_back(std::move(entry));
  }
  return json;
}

Json where_json(const scene::Where& where, std::optional<double> metres_per_unit) {
  Json json;
  json["file"] = where.file;
  json["line"] = line_json(where.line);
  json["point"] = where.point ? point_json(*where.point) : Json(nullptr);
  json["pointMetres"] = where.point ? metres_json(*where.point, metres_per_unit) : Json(nullptr);
  json["segment"] = pair_json(where.segment);
  json["bounds"] = pair_json(where.bounds);
  json["objects"] = where.objects;
  json["materials"] = where.materials;
  json["pointer"] = text_or_null(where.pointer);
  json["byteOffset"] = where.byte_offset ? Json(*where.byte_offset) : Json(nullptr);
  json["faces"] = faces_json(where.faces);
  json["faceCount"] = where.face_count;
  return json;
}

Json measure_json(const std::optional<scene::Measure>& measure) {
  if (!measure) return nullptr;
  Json json;
  json["name"] = measure->name;
  json["value"] = number(measure->value);
  json["threshold"] = measure->threshold ? number(*measure->threshold) : Json(nullptr);
  json["unit"] = measure->unit;
  return json;
}

Json finding_json(const scene::Finding& finding, std::size_t input_index, std::optional<double> metres_per_unit) {
  Json json;
  json["rule"] = finding.rule;
  json["alias"] = finding.alias;
  json["requirement"] = finding.requirement;
  json["severity"] = scene::name(finding.severity);
  json["kind"] = scene::name(finding.kind);
  json["message"] = finding.message;
  json["measure"] = measure_json(finding.measure);
  json["input"] = input_index;
  json["where"] = where_json(finding.where, metres_per_unit);
  json["count"] = finding.count;
  json["fingerprint"] = finding.fingerprint;
  json["fix"]["class"] = scene::name(finding.fix.applicability);
  json["fix"]["op"] = text_or_null(finding.fix.operation);
  return json;
}

// The cap holds for each rule of each input, so that no rule that occurs is hidden.
Json findings_json(const Report& report) {
  Json json = Json::array();
  for (std::size_t index = 0; index < report.inputs.size(); ++index) {
    const InputReport& input = report.inputs[index];
    std::map<std::string_view, std::size_t> listed;
    for (const scene::Finding& finding : input.result.findings) {
      if (report.max_issues > 0 && ++listed[finding.rule] > report.max_issues) continue;
      json.push_back(finding_json(finding, index, input.metres_per_unit));
    }
  }
  return json;
}

Json invocation_json(const Report& report) {
  Json json;
  json["stage"] = validate::name(report.stage);
  json["failOn"] = name(report.fail_on);
  json["select"] = report.select;
  json["ignore"] = report.ignore;
  return json;
}

}  // namespace

std::string json(const Report& report, bool with_timings) {
  Json json;
  json["schemaVersion"] = kSchemaVersion;
  json["tool"] = tool_json(report.tool);
  json["invocation"] = invocation_json(report);
  json["inputs"] = inputs_json(report);
  json["tolerance"] = only_tolerance_json(report);
  json["verdict"] = counts(report).errors == 0 ? "pass" : "fail";
  json["summary"] = summary_json(report);
  json["findings"] = findings_json(report);
  json["timings"] = timings_json(report, with_timings);
  return written(json);
}

}  // namespace rad::report
