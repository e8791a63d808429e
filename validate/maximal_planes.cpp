#include "validate/maximal_planes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/texture_map.h"

namespace rad::validate {
namespace {

bool all_within(const Context& context, FaceId face, const dvec3& through, const dvec3& unit_normal) {
  const auto tolerance = static_cast<double>(context.tolerance.pitches);
  for (const scene::Loop& loop : context.scene.loops_of(context.scene.faces[face])) {
    for (const PointId p : context.model.corners_of(loop)) {
      if (std::abs(glm::dot(unit_normal, geom::as_vector(context.model.points[p]) - through)) > tolerance) return false;
    }
  }
  return true;
}

// Coplanar or crossing segments that come within `reach`: an end of one is near the other, or they cross. Ends cover
// the contacts that matter here, which stop at the outline of a face.
bool come_near(const std::array<dvec3, 2>& a, const std::array<dvec3, 2>& b, double reach) {
  return geom::distance_to_segment(a[0], b[0], b[1]) <= reach || geom::distance_to_segment(a[1], b[0], b[1]) <= reach ||
         geom::distance_to_segment(b[0], a[0], a[1]) <= reach || geom::distance_to_segment(b[1], a[0], a[1]) <= reach;
}

std::optional<PlanarSeam> seam_at(const Context& context, const Subedge& subedge) {
  if (subedge.count != 2) return std::nullopt;
  const auto coedges = context.topology.coedges_of(subedge);
  const FaceId a = coedges[0].face, b = coedges[1].face;
  if (coedges[0].forward == coedges[1].forward || !context.is_sound(a) || !context.is_sound(b)) return std::nullopt;
  if (!coplanar_within_tolerance(context, a, b) || contact_on_subedge(context, subedge, a, b)) return std::nullopt;
  const scene::Scene& scene = context.scene;
  const bool same = scene::same_texture_map(scene, scene.faces[a], scene.faces[b], context.tolerance.length);
  return PlanarSeam{&subedge, a, b, !same};
}

}  // namespace

bool coplanar_within_tolerance(const Context& context, FaceId a, FaceId b) {
  if (context.material_of(a) != context.material_of(b) || context.object_of(a) != context.object_of(b)) return false;
  const dvec3& m = context.triangles.normal[a];
  const dvec3& n = context.triangles.normal[b];
  if (glm::dot(m, n) <= 0) return false;
  const bool a_larger = glm::length(m) >= glm::length(n);
  const FaceId larger = a_larger ? a : b, smaller = a_larger ? b : a;
  const scene::Loop& loop = context.scene.loops[context.scene.faces[larger].first_loop];
  const dvec3 through = geom::as_vector(context.model.points[context.model.corners_of(loop)[0]]);
  return all_within(context, smaller, through, glm::normalize(a_larger ? m : n));
}

bool contact_on_subedge(const Context& context, const Subedge& subedge, FaceId a, FaceId b) {
  const std::array<dvec3, 2> edge{geom::as_vector(context.model.points[subedge.a]),
                                  geom::as_vector(context.model.points[subedge.b])};
  const auto reach = static_cast<double>(context.tolerance.pitches);
  for (const FaceId face : {a, b}) {
    const auto [first, last] = context.contacts_of(face);
    for (auto at = first; at != last; ++at) {
      const FaceContact& contact = context.contacts.faces[*at];
      if (contact.kind == geom::ContactKind::Overlap) continue;
      const FaceId other = contact.a == face ? contact.b : contact.a;
      if (other != a && other != b && come_near(contact.segment, edge, reach)) return true;
    }
  }
  return false;
}

std::vector<PlanarSeam> planar_seams(const Context& context) {
  const auto& subedges = context.topology.subedges;
  constexpr std::size_t kSubedgesPerBlock = 8192;
  std::vector<std::vector<PlanarSeam>> blocks((subedges.size() + kSubedgesPerBlock - 1) / kSubedgesPerBlock);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t block) {
    const std::size_t end = std::min(subedges.size(), (block + 1) * kSubedgesPerBlock);
    for (std::size_t i = block * kSubedgesPerBlock; i < end; ++i) {
      if (const auto seam = seam_at(context, subedges[i])) blocks[block].push_back(*seam);
    }
  });
  std::vector<PlanarSeam> seams;
  for (const auto& block : blocks) seams.insert(seams.end(), block.begin(), block.end());
  return seams;
}

void report_seams(const Context& context, bool keeping_texture, Violations& out) {
  if (keeping_texture && context.scene.attributes.texture_coordinates.empty()) return;
  for (const PlanarSeam& seam : planar_seams(context)) {
    if (seam.keeps_texture != keeping_texture) continue;
    const Subedge& subedge = *seam.subedge;
    const dvec3 from = context.position(subedge.a), to = context.position(subedge.b);
    const auto squared = geom::squared_distance(context.model.points[subedge.a], context.model.points[subedge.b]);
    out.add({.faces = {seam.a, seam.b},
             .point = (from + to) * 0.5,
             .segment = std::array{from, to},
             .measure = context.length(std::sqrt(static_cast<double>(squared))),
             .cluster = context.topology.component_of_face[seam.a] + std::uint64_t{1}});
  }
}

}  // namespace rad::validate
