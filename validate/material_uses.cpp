#include "validate/material_uses.h"

#include <algorithm>

namespace rad::validate {
namespace {

PointId least_corner(const Context& context, const scene::Face& face) {
  const auto corners = context.model.corners_of(context.scene.loops[face.first_loop]);
  return corners.empty() ? scene::kNoPoint : *std::ranges::min_element(corners);
}

struct Shown {
  PointId corner = scene::kNoPoint;
  FaceId face = kNoFace;
};

}  // namespace

void for_each_material_at_fault(const Context& context, const std::function<bool(const scene::Material&)>& at_fault,
                                const std::function<void(const scene::Material&, FaceId)>& visit) {
  const auto& materials = context.scene.materials;
  std::vector<bool> faulty;
  for (const scene::Material& material : materials) faulty.push_back(at_fault(material));
  if (std::ranges::find(faulty, true) == faulty.end()) return;
  std::vector<Shown> shown(materials.size());
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    const scene::Face& face = context.scene.faces[id];
    if (!faulty[face.material] || context.model.left_out[id]) continue;
    Shown& best = shown[face.material];
    const PointId corner = least_corner(context, face);
    const bool first = best.face == kNoFace || corner < best.corner;
    if (first || (corner == best.corner && context.precedes(id, best.face))) best = {corner, id};
  }
  for (scene::MaterialId id = 0; id < materials.size(); ++id) {
    if (shown[id].face != kNoFace) visit(materials[id], shown[id].face);
  }
}

Violation material_violation(const Context& context, FaceId face, double measure) {
  return {.faces = {face, kNoFace}, .point = context.centre(face), .measure = measure, .cluster = kWholeModel};
}

double brightest(const dvec3& colour) { return std::max({colour.x, colour.y, colour.z}); }

}  // namespace rad::validate
