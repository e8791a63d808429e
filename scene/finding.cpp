#include "scene/finding.h"

namespace rad::scene {

std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "error";
}

std::string_view name(FindingKind kind) {
  switch (kind) {
    case FindingKind::Fail:
      return "fail";
    case FindingKind::Review:
      return "review";
    case FindingKind::Informational:
      return "informational";
  }
  return "fail";
}

std::string_view name(FixClass applicability) {
  switch (applicability) {
    case FixClass::Safe:
      return "safe";
    case FixClass::Unsafe:
      return "unsafe";
    case FixClass::Manual:
      return "manual";
    case FixClass::None:
      return "none";
  }
  return "none";
}

std::string_view name(BaselineState state) {
  switch (state) {
    case BaselineState::None:
      return "";
    case BaselineState::New:
      return "new";
    case BaselineState::Grown:
      return "grown";
    case BaselineState::Known:
      return "known";
  }
  return "";
}

FaceReference reference_to(const Scene& scene, FaceId face) {
  FaceReference reference;
  const SourceRef& source = scene.faces[face].source;
  if (source.section >= scene.sections.size()) {
    reference.ref = scene.path + " face " + std::to_string(face);
    return reference;
  }
  const SourceSection& section = scene.sections[source.section];
  switch (section.kind) {
    case RecordKind::Line:
      reference.line = source.record;
      reference.ref = section.file + ":" + std::to_string(source.record);
      break;
    case RecordKind::Element:
      reference.pointer = section.pointer;
      reference.ref = section.file + "#" + section.pointer + " triangle " + std::to_string(source.record);
      break;
    case RecordKind::ByteOffset:
      reference.ref = section.file + " byte " + std::to_string(source.record);
      break;
    case RecordKind::Item:
      reference.pointer = section.pointer + "/" + std::to_string(source.record);
      reference.ref = section.file + "#" + reference.pointer;
      break;
  }
  reference.entity = scene.entities[scene.faces[face].entity];
  if (!reference.entity.empty()) reference.ref += " (" + reference.entity + ")";
  return reference;
}

}  // namespace rad::scene
