#include "validate/face_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geom/planar_shape.h"
#include "validate/rings.h"

namespace rad::validate {
namespace {

// The corners of the outer loop in an orthonormal frame of the face's plane, in pitches; from the smallest on, so that
// rounding does not depend on the corner that the file starts with.
std::vector<geom::PlanePoint> flattened(const Context& context, FaceId face) {
  const auto corners = context.model.corners_of(context.scene.loops[context.scene.faces[face].first_loop]);
  std::vector<PointId> ring(corners.begin(), corners.end());
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  const auto vector_of = [&](PointId id) {
    const geom::LatticePoint& p = context.model.points[id];
    return dvec3(p.x, p.y, p.z);
  };
  const dvec3 origin = vector_of(ring[0]);
  const dvec3 u = glm::normalize(vector_of(ring[1]) - origin);
  const dvec3 v = glm::cross(glm::normalize(context.triangles.normal[face]), u);
  std::vector<geom::PlanePoint> points;
  for (const PointId p : ring) {
    const dvec3 offset = vector_of(p) - origin;
    points.push_back({glm::dot(offset, u), glm::dot(offset, v)});
  }
  return points;
}

}  // namespace

std::uint64_t corner_count(const Context& context, FaceId face) {
  std::uint64_t count = 0;
  for (const scene::Loop& loop : context.scene.loops_of(context.scene.faces[face])) count += loop.count;
  return count;
}

bool is_triangle_or_convex_quad(const Context& context, FaceId face) {
  const scene::Face& record = context.scene.faces[face];
  const scene::Loop& loop = context.scene.loops[record.first_loop];
  if (record.loop_count != 1 || loop.count > 4) return false;
  if (loop.count == 3) return true;
  const dvec3& n = context.triangles.normal[face];
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  const int dropped = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  std::vector<geom::PlanarPoint> points;
  for (const PointId p : context.model.corners_of(loop))
    points.push_back(geom::project(context.model.points[p], dropped));
  return is_convex(points, Ring{0, 1, 2, 3}, true);
}

double scaled_shape(const Context& context, FaceId face) { return geom::scaled_shape(flattened(context, face)); }

}  // namespace rad::validate
