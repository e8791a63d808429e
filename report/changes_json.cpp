#include "report/changes_json.h"

namespace rad::report {
namespace {

Json place_json(const ChangePlace& place) {
  Json face;
  face["ref"] = place.face.ref;
  face["line"] = place.face.line > 0 ? Json(place.face.line) : Json(nullptr);
  face["pointer"] = place.face.pointer.empty() ? Json(nullptr) : Json(place.face.pointer);
  return {{"face", std::move(face)}, {"at", point_json(place.at)}, {"distance", number(place.distance)}};
}

std::string_view name(scene::RecordKind kind) {
  switch (kind) {
    case scene::RecordKind::Line:
      return "line";
    case scene::RecordKind::Element:
      return "element";
    case scene::RecordKind::Item:
      return "item";
    case scene::RecordKind::ByteOffset:
      return "byte";
  }
  return "line";
}

}  // namespace

Json changes_json(const Changes& changes) {
  Json list = Json::array();
  for (const Change& change : changes.kinds) {
    Json places = Json::array();
    for (const ChangePlace& place : change.places) places.push_back(place_json(place));
    list.push_back({{"kind", change.kind}, {"count", change.count}, {"places", std::move(places)}});
  }
  return list;
}

Json merged_json(const std::vector<MergedRegion>& regions) {
  Json list = Json::array();
  for (const MergedRegion& region : regions) {
    list.push_back({{"at", point_json(region.at)}, {"distance", number(region.distance)}, {"places", region.places}});
  }
  return list;
}

Json provenance_json(const Provenance& provenance) {
  Json sections = Json::array(), places = Json::array();
  for (const scene::SourceSection& section : provenance.sections) {
    sections.push_back({{"file", section.file},
                        {"pointer", section.pointer.empty() ? Json(nullptr) : Json(section.pointer)},
                        {"record", name(section.kind)}});
  }
  for (const InputPlaces& stretch : provenance.places) {
    places.push_back({{"section", stretch.section}, {"records", stretch.records}});
  }
  return {{"outputFaces", provenance.output_faces},
          {"sources", provenance.sources},
          {"inputFaces", provenance.input_faces},
          {"sections", std::move(sections)},
          {"places", std::move(places)}};
}

Json contracts_json(const std::vector<ContractCheck>& checks) {
  Json list = Json::array();
  for (const ContractCheck& check : checks) {
    list.push_back({{"stage", check.stage},
                    {"requirement", check.requirement},
                    {"cell", check.cell},
                    {"before", check.before},
                    {"after", check.after},
                    {"holds", check.holds}});
  }
  return list;
}

}  // namespace rad::report
