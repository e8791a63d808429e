#include "repair/surface_order.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>
#include <tuple>

namespace rad::repair {
namespace {

// Equal sheets must not change places for the noise of their measures.
constexpr double kAreaBand = 1e-3;

struct Surface {
  bool emits = false;
  double area = 0;  ///< pitches²
  std::string_view material;
  std::string_view object;
  scene::PointId smallest_point = scene::kNoPoint;
  scene::FaceId face = 0;  ///< representative
};

auto key(const Surface& surface) {
  const double band = surface.area > 0 ? std::round(std::log(surface.area) / std::log1p(kAreaBand)) : -1e9;
  return std::tuple(!surface.emits, band, surface.material, surface.object, surface.smallest_point, surface.face);
}

std::vector<Surface> surfaces_of(const validate::Context& context) {
  std::vector<Surface> surfaces(context.scene.faces.size());
  for (scene::FaceId face = 0; face < surfaces.size(); ++face) {
    const scene::FaceId representative = context.topology.surface_of_face[face];
    const scene::Material& material = context.scene.materials[context.material_of(face)];
    Surface& surface = surfaces[representative];
    surface.emits = material.emits();
    surface.material = material.name;
    surface.object = context.scene.objects[context.object_of(face)];
    surface.face = representative;
    surface.area += glm::length(context.triangles.normal[face]) / 2;
    for (const scene::Loop& loop : context.scene.loops_of(context.scene.faces[face])) {
      for (const scene::PointId point : context.model.corners_of(loop)) {
        surface.smallest_point = std::min(surface.smallest_point, point);
      }
    }
  }
  return surfaces;
}

}  // namespace

std::vector<std::uint32_t> surface_ranks(const validate::Context& context) {
  const std::vector<Surface> surfaces = surfaces_of(context);
  std::vector<scene::FaceId> order;
  for (scene::FaceId face = 0; face < surfaces.size(); ++face) {
    if (context.topology.surface_of_face[face] == face) order.push_back(face);
  }
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(surfaces[a]) < key(surfaces[b]); });
  std::vector<std::uint32_t> rank_of_surface(surfaces.size(), 0);
  for (std::uint32_t rank = 0; rank < order.size(); ++rank) rank_of_surface[order[rank]] = rank;
  std::vector<std::uint32_t> ranks(surfaces.size());
  for (scene::FaceId face = 0; face < ranks.size(); ++face) {
    ranks[face] = rank_of_surface[context.topology.surface_of_face[face]];
  }
  return ranks;
}

}  // namespace rad::repair
