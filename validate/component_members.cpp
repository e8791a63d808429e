#include "validate/component_members.h"

#include <algorithm>
#include <cmath>

namespace rad::validate {

ComponentMembers members_of_components(const Context& context) {
  ComponentMembers members;
  members.triangles.resize(context.topology.components.size());
  members.faces.resize(context.topology.components.size());
  const auto& component_of = context.topology.component_of_face;
  for (std::uint32_t i = 0; i < context.triangles.triangles.size(); ++i) {
    members.triangles[component_of[context.triangles.triangles[i].face]].push_back(i);
  }
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    if (component_of[id] != kNoComponent) members.faces[component_of[id]].push_back(id);
  }
  return members;
}

double volume_of(const Component& component) { return std::abs(static_cast<double>(component.volume6)) / 6; }

bool has_volume(const Context& context, const Component& component) {
  return volume_of(component) > component.area * static_cast<double>(context.tolerance.pitches);
}

bool box_inside(const Component& inner, const Component& outer) {
  return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.low.z >= outer.low.z &&
         inner.high.x <= outer.high.x && inner.high.y <= outer.high.y && inner.high.z <= outer.high.z;
}

FaceId first_face(const Context& context, const std::vector<FaceId>& faces) {
  return *std::ranges::min_element(faces, [&](FaceId a, FaceId b) { return context.precedes(a, b); });
}

bool any_emits(const Context& context, const std::vector<FaceId>& faces) {
  return std::ranges::any_of(faces,
                             [&](FaceId face) { return context.scene.materials[context.material_of(face)].emits(); });
}

}  // namespace rad::validate
