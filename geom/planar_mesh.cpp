#include "geom/planar_mesh.h"

namespace rad::geom {
namespace {

int edge_towards(const PlanarTriangle& triangle, std::uint32_t neighbour) {
  for (int edge = 0; edge < 3; ++edge) {
    if (triangle.neighbour[edge] == neighbour) return edge;
  }
  return 0;
}

void relink(std::vector<PlanarTriangle>& triangles, std::uint32_t at, std::uint32_t from, std::uint32_t to) {
  if (at != kNoTriangle) triangles[at].neighbour[edge_towards(triangles[at], from)] = to;
}

}  // namespace

void PlanarMesh::flip(std::uint32_t triangle, int edge) {
  const std::uint32_t other = triangles[triangle].neighbour[edge];
  const PlanarTriangle t = triangles[triangle];
  const PlanarTriangle o = triangles[other];
  const int back = edge_towards(o, triangle);
  const int t1 = (edge + 1) % 3, t2 = (edge + 2) % 3, o1 = (back + 1) % 3, o2 = (back + 2) % 3;
  const std::uint32_t a = t.corner[edge], b = t.corner[t1], apex = t.corner[t2], far = o.corner[o2];
  // Before: (a, b, apex) and (b, a, far). After: (a, far, apex) and (far, b, apex).
  triangles[triangle] = {
      {a, far, apex}, {o.neighbour[o1], other, t.neighbour[t2]}, {o.constrained[o1], false, t.constrained[t2]}};
  triangles[other] = {
      {far, b, apex}, {o.neighbour[o2], t.neighbour[t1], triangle}, {o.constrained[o2], t.constrained[t1], false}};
  relink(triangles, o.neighbour[o1], other, triangle);
  relink(triangles, t.neighbour[t1], triangle, other);
}

}  // namespace rad::geom
