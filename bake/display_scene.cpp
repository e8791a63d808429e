#include "bake/display_scene.h"

namespace rad::bake {

scene::Scene display_scene(const mesh::DisplayMesh& display, const geom::Lattice& lattice, const scene::Scene& origin) {
  scene::Scene scene;
  scene.path = origin.path;
  scene.format = origin.format;
  scene.materials = origin.materials;
  scene.objects = origin.objects;
  scene.entities.emplace_back();
  scene.groups = origin.groups;
  scene.sections.push_back({.file = origin.path, .pointer = {}, .kind = scene::RecordKind::Element});
  scene.metres_per_unit = origin.metres_per_unit;
  scene.up = origin.up;
  scene.vertices.reserve(display.vertices.size());
  for (const mesh::DisplayVertex& vertex : display.vertices) scene.vertices.push_back(lattice.position(vertex.point));
  scene.faces.reserve(display.faces.size());
  for (const mesh::DisplayFace& face : display.faces) {
    const auto index = static_cast<std::uint32_t>(scene.faces.size());
    scene.loops.push_back({static_cast<std::uint32_t>(scene.corners.size()), face.count});
    scene.corners.insert(scene.corners.end(), face.corner.begin(), face.corner.begin() + face.count);
    scene.faces.push_back({.first_loop = index,
                           .loop_count = 1,
                           .material = face.material,
                           .object = face.object,
                           .group = face.group,
                           .source = {.section = 0, .record = index}});
  }
  return scene;
}

}  // namespace rad::bake
