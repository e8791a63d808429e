#include "scene/bad_faces.h"

#include <algorithm>
#include <cmath>

namespace rad::scene {
namespace {

bool is_finite(const dvec3& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

}  // namespace

std::size_t drop_bad_faces(Scene& scene) {
  const std::size_t dropped = std::erase_if(scene.faces, [&](const Face& face) {
    return std::ranges::any_of(scene.loops_of(face), [&](const Loop& loop) {
      return std::ranges::any_of(scene.corners_of(loop),
                                 [&](VertexId corner) { return !is_finite(scene.vertices[corner]); });
    });
  });
  const auto sound = std::ranges::find_if(scene.vertices, &is_finite);
  const dvec3 place = sound == scene.vertices.end() ? dvec3{0, 0, 0} : *sound;
  std::ranges::replace_if(scene.vertices, [](const dvec3& vertex) { return !is_finite(vertex); }, place);
  return dropped;
}

}  // namespace rad::scene
