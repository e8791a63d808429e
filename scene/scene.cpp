#include "scene/scene.h"

#include <utility>

namespace rad::scene {

Scene empty_scene(std::string path, std::string format) {
  Scene scene;
  scene.path = std::move(path);
  scene.format = std::move(format);
  scene.materials.emplace_back();
  scene.objects.emplace_back();
  scene.groups.emplace_back();
  scene.entities.emplace_back();
  return scene;
}

Scene without_geometry(const Scene& scene) {
  Scene empty;
  empty.path = scene.path;
  empty.format = scene.format;
  empty.materials = scene.materials;
  empty.objects = scene.objects;
  empty.groups = scene.groups;
  empty.entities = scene.entities;
  empty.sections = scene.sections;
  empty.metres_per_unit = scene.metres_per_unit;
  empty.up = scene.up;
  empty.declared_tolerance = scene.declared_tolerance;
  return empty;
}

bool has_texture_coordinates(const Scene& scene, const Face& face) {
  const Loop& outer = scene.loops[face.first_loop];
  return outer.count > 0 && scene.attributes.texture_coordinates.row(outer.first) != kNoRow;
}

}  // namespace rad::scene
