#include "report/finding_json.h"

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
  for (const scene::FaceReference& face : faces) json.push_back(face_json(face));
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
  json["frame"] = where.frame ? point_json(*where.frame) : Json(nullptr);
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

}  // namespace

Json face_json(const scene::FaceReference& face) {
  Json json;
  json["ref"] = face.ref;
  json["line"] = line_json(face.line);
  json["pointer"] = text_or_null(face.pointer);
  if (!face.entity.empty()) json["entity"] = face.entity;
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
  if (finding.area) json["area"] = number(*finding.area);
  if (finding.kept_below) json["keptBelow"] = number(*finding.kept_below);
  json["input"] = input_index;
  json["where"] = where_json(finding.where, metres_per_unit);
  json["count"] = finding.count;
  json["fingerprint"] = finding.fingerprint;
  if (finding.baseline != scene::BaselineState::None) json["baseline"] = scene::name(finding.baseline);
  json["fix"]["class"] = scene::name(finding.fix.applicability);
  json["fix"]["op"] = text_or_null(finding.fix.operation);
  return json;
}

}  // namespace rad::report
