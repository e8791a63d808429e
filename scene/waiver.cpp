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
      return face.source.section == waiver.section && face.source.record >= waiver.first &&
             face.source.record <= waiver.last;
    case WaiverScope::Object:
      return face.object == waiver.id;
    case WaiverScope::Material:
      return face.material == waiver.id;
    case WaiverScope::Primitive:
      return face.source.section < scene.sections.size() &&
             is_at_or_below(scene.sections[face.source.section].pointer, waiver.pointer);
  }
  return false;
}

}  // namespace rad::scene
