#include "writers/model.h"

#include <algorithm>
#include <cmath>

namespace rad::writers {
namespace {

bool finite(const geom::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool has_a_face(const scene::Scene& scene) {
  return std::ranges::any_of(scene.faces,
                             [&](const scene::Face& face) { return scene.loops[face.first_loop].count > 0; });
}

bool fits(const scene::LightMap& map, const scene::Scene& scene) {
  const std::size_t faces = scene.faces.size();
  return map.white_luminance.size() == faces && map.page_of_face.size() == faces && map.coordinates.size() == scene.corners.size() &&
         std::ranges::all_of(map.page_of_face, [&](std::uint32_t page) { return page < map.pages.size(); });
}

}  // namespace

std::string problem_of(const Output& output) {
  if (!has_a_face(output.scene)) return "there is no face to write";
  if (output.light == nullptr) return {};
  const std::size_t vertices = output.scene.vertices.size();
  if (output.light->radiosity.size() != vertices || output.light->colour.size() != vertices) {
    return "the light does not fit the " + std::to_string(vertices) + " vertices";
  }
  if (output.light_map != nullptr && !fits(*output.light_map, output.scene)) {
    return "the light map does not fit the faces";
  }
  const bool sound =
      std::ranges::all_of(output.light->radiosity, finite) && std::ranges::all_of(output.light->colour, finite);
  return sound ? std::string() : std::string("the light of a vertex is not finite");
}

}  // namespace rad::writers
