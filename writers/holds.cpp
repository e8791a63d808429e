#include "writers/holds.h"

#include <algorithm>

namespace rad::writers {
namespace {

using scene::Material;
using scene::Scene;

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// Materials and names that faces use.
struct Uses {
  std::vector<bool> materials, objects, groups;

  explicit Uses(const Scene& scene)
      : materials(scene.materials.size()), objects(scene.objects.size()), groups(scene.groups.size()) {
    for (const scene::Face& face : scene.faces) {
      materials[face.material] = true;
      objects[face.object] = true;
      groups[face.group] = true;
    }
  }
};

std::size_t named(const std::vector<std::string>& names, const std::vector<bool>& used) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < names.size(); ++i) count += used[i] && !names[i].empty() ? 1 : 0;
  return count;
}

template <typename Has>
std::size_t materials_that(const Scene& scene, const Uses& uses, Has has) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    count += uses.materials[i] && has(scene.materials[i]) ? 1 : 0;
  return count;
}

std::size_t faces_beyond(const Scene& scene, Corners corners) {
  if (corners == Corners::Any) return 0;
  const std::uint32_t most = corners == Corners::Three ? 3 : 4;
  return static_cast<std::size_t>(std::ranges::count_if(scene.faces, [&](const scene::Face& face) {
    return face.loop_count > 1 || scene.loops[face.first_loop].count > most;
  }));
}

void add_shapes(const Scene& scene, const Holds& holds, std::vector<std::string>& losses) {
  if (const std::size_t count = faces_beyond(scene, holds.corners); count > 0) {
    losses.push_back(counted(count, "face is", "faces are") + " divided into triangles");
  } else if (!holds.holes) {
    const auto count_holes = static_cast<std::size_t>(
        std::ranges::count_if(scene.faces, [](const scene::Face& face) { return face.loop_count > 1; }));
    if (count_holes > 0)
      losses.push_back(counted(count_holes, "face has", "faces have") + " holes, reached over a seam");
  }
  if (!holds.doubles && !scene.single_precision) losses.emplace_back("coordinates beyond single precision");
  if (!holds.unit && scene.metres_per_unit) losses.emplace_back("the unit");
}

}  // namespace

std::vector<std::string> losses_of(const Scene& scene, const Holds& holds) {
  const Uses uses(scene);
  std::vector<std::string> losses;
  add_shapes(scene, holds, losses);
  const auto add = [&](bool held, std::size_t count, const char* one, const char* many) {
    if (!held && count > 0) losses.push_back(counted(count, one, many));
  };
  add(holds.objects, named(scene.objects, uses.objects), "name of an object", "names of objects");
  add(holds.groups, named(scene.groups, uses.groups), "name of a group", "names of groups");
  const auto has_name = [](const Material& material) { return !material.name.empty(); };
  add(holds.materials, materials_that(scene, uses, has_name), "name of a material", "names of materials");
  const auto reflects = [](const Material& material) { return material.reflectance_stated; };
  add(holds.reflectance, materials_that(scene, uses, reflects), "reflectance", "reflectances");
  const auto does_both = [](const Material& material) { return material.emits() && material.reflectance_stated; };
  add(!holds.reflectance || holds.reflecting_lights, materials_that(scene, uses, does_both), "reflectance of a light",
      "reflectances of lights");
  const auto emits = [](const Material& material) { return material.emits(); };
  add(holds.emission, materials_that(scene, uses, emits), "emission of light", "emissions of light");
  const auto has_image = [](const Material& material) { return material.texture.has_value(); };
  add(holds.images, materials_that(scene, uses, has_image), "image of a material", "images of materials");
  return losses;
}

}  // namespace rad::writers
