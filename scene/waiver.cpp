#include "scene/waiver.h"

namespace rad::scene {

namespace {

bool is_at_or_below(std::string_view pointer, std::string_view above) {
  if (!pointer.starts_with(above)) return false;
  return pointer.size() == above.size() || pointer[above.size()] == '/';
}

}  // namespace

bool covers(const Waiver& waiver, const Scene& scene, FaceId id) {
  if (!waiver.fault.empty()) return false;
  const Face& face = scene.faces[id];
  switch (waiver.scope) {
    case WaiverScope::File:
      return true;
    case WaiverScope::Records:
      return covers_record(waiver, face.source);
    case WaiverScope::Object:
      return face.object == waiver.id;
    case WaiverScope::Material:
      return face.material == waiver.id;
    case WaiverScope::Primitive:
      return face.source.section < scene.sections.size() &&
             is_at_or_below(scene.sections[face.source.section].pointer, waiver.pointer);
    case WaiverScope::Names:
      break;
  }
  return false;
}

bool covers_record(const Waiver& waiver, const SourceRef& record) {
  if (!waiver.fault.empty()) return false;
  if (waiver.scope == WaiverScope::File) return true;
  return waiver.scope == WaiverScope::Records && record.section == waiver.section && record.record >= waiver.first &&
         record.record <= waiver.last;
}

std::string_view name(WaiverOrigin origin) {
  switch (origin) {
    case WaiverOrigin::Model:
      return "comment";
    case WaiverOrigin::Sidecar:
      return "sidecar";
    case WaiverOrigin::Configuration:
      return "configuration";
  }
  return "comment";
}

}  // namespace rad::scene
