#include "validate/neighbours.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

namespace rad::validate {
namespace {

using Pairs = std::vector<std::array<Coedge, 2>>;

std::vector<PointId> corner_set(const Context& context, FaceId face) {
  std::vector<PointId> points;
  for (const scene::Loop& loop : context.scene.loops_of(context.scene.faces[face])) {
    const auto corners = context.model.corners_of(loop);
    points.insert(points.end(), corners.begin(), corners.end());
  }
  std::sort(points.begin(), points.end());
  return points;
}

// Two solids that touch lie on different sides of their common face; the copies of a face that is there twice on one.
bool on_different_sides(const Context& context, FaceId common, FaceId a, FaceId b) {
  const dvec3& normal = context.triangles.normal[common];
  const dvec3 middle = context.centre(common);
  return glm::dot(normal, context.centre(a) - middle) * glm::dot(normal, context.centre(b) - middle) < 0;
}

// The two that lie on each other, and the other two; nothing where that does not tell the four apart.
void pair_up_four(const Context& context, std::span<const Coedge> coedges, Pairs& pairs) {
  Pairs found;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      if (!have_the_same_corners(context, coedges[i].face, coedges[j].face)) continue;
      std::array<std::size_t, 2> others{};
      std::size_t count = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        if (k != i && k != j) others[count++] = k;
      }
      const Coedge &first = coedges[others[0]], &second = coedges[others[1]];
      if (!on_different_sides(context, coedges[i].face, first.face, second.face)) continue;
      found.push_back({coedges[i], coedges[j]});
      found.push_back({first, second});
    }
  }
  if (found.size() == 2) pairs.insert(pairs.end(), found.begin(), found.end());
}

}  // namespace

bool have_the_same_corners(const Context& context, FaceId a, FaceId b) {
  return a != b && corner_set(context, a) == corner_set(context, b);
}

Pairs neighbours_at(const Context& context, const Subedge& subedge) {
  std::map<scene::ObjectId, std::vector<Coedge>> by_object;
  for (const Coedge& coedge : context.topology.coedges_of(subedge)) {
    by_object[context.object_of(coedge.face)].push_back(coedge);
  }
  Pairs pairs;
  for (const auto& [object, coedges] : by_object) {
    if (coedges.size() == 2 && coedges[0].face != coedges[1].face) pairs.push_back({coedges[0], coedges[1]});
    // Where formats name no objects, four may as well be of two.
    if (coedges.size() == 4 && !context.scene.objects[object].empty()) pair_up_four(context, coedges, pairs);
  }
  return pairs;
}

}  // namespace rad::validate
