#include "repair/covered_triangles.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <tuple>

#include "repair/plane_groups.h"

namespace rad::repair {
namespace {

double area_of(std::span<const LatticePoint> points, const std::array<PointId, 3>& ids) {
  const dvec3 a = geom::as_vector(points[ids[0]]);
  return glm::length(glm::cross(geom::as_vector(points[ids[1]]) - a, geom::as_vector(points[ids[2]]) - a)) / 2;
}

// Pieces of the triangle's facing that cover it, the winner first.
std::vector<PieceId> pieces_at(const Conformed& conformed, const Triangle& triangle) {
  if (triangle.cluster == kNoCluster) return {triangle.winner};
  const auto pieces = conformed.complex->pieces();
  std::vector<PieceId> found;
  for (const PieceId id : conformed.triangulation.cover_of(triangle)) {
    if (pieces[id].along == triangle.along) found.push_back(id);
  }
  std::ranges::sort(found, {}, [&](PieceId id) { return std::pair(pieces[id].rank, id); });
  return found;
}

class Layers {
 public:
  explicit Layers(const scene::Scene& scene) : scene_(scene) {}

  // How many of the pieces so far are like this one.
  std::uint32_t next(scene::FaceId source) {
    const scene::Face& face = scene_.faces[source];
    const auto likeness = std::tuple(face.material, face.object, face.group);
    const auto layer = std::ranges::count(seen_, likeness);
    seen_.push_back(likeness);
    return static_cast<std::uint32_t>(layer);
  }

 private:
  const scene::Scene& scene_;
  std::vector<std::tuple<scene::MaterialId, scene::ObjectId, scene::GroupId>> seen_;
};

}  // namespace

PlanarTriangles planar_triangles(const Conformed& conformed, const scene::Scene& scene, Overlaps overlaps,
                                 std::int64_t tolerance) {
  const Complex& complex = *conformed.complex;
  PlanarTriangles set;
  set.points.assign(complex.points().begin(), complex.points().end());
  for (const std::uint32_t i : conformed.triangulation.living()) {
    const Triangle& triangle = conformed.triangulation.triangles()[i];
    PlanarTriangles::Member member{triangle.points, triangle.cluster, triangle.along, 0};
    if (overlaps == Overlaps::Resolved) {
      const Piece& winner = complex.pieces()[triangle.winner];
      member.source = winner.source;
      member.won = winner.won || conformed.triangulation.hides_others(complex, triangle);
      set.members.push_back(member);
      continue;
    }
    Layers layers(scene);
    for (const PieceId id : pieces_at(conformed, triangle)) {
      member.source = complex.pieces()[id].source;
      member.layer = layers.next(member.source);
      set.members.push_back(member);
    }
  }
  group_by_planes(set, static_cast<double>(tolerance));
  return set;
}

double area_of(const PlanarTriangles& set) {
  double sum = 0;
  for (const auto& member : set.members) sum += area_of(set.points, member.points);
  return sum;
}

scene::Scene scene_of(const PlanarTriangles& set, const scene::Scene& origin, const geom::Lattice& lattice,
                      double tolerance) {
  scene::Scene scene = scene::without_geometry(origin);
  scene.recorded = scene::RecordedLattice{lattice, tolerance};
  for (const LatticePoint& point : set.points) scene.vertices.push_back(lattice.position(point));
  for (const auto& member : set.members) {
    scene::Face face = origin.faces[member.source];
    face.first_loop = static_cast<std::uint32_t>(scene.loops.size());
    face.loop_count = 1;
    scene.faces.push_back(face);
    scene.loops.push_back({static_cast<std::uint32_t>(scene.corners.size()), 3});
    scene.corners.insert(scene.corners.end(), member.points.begin(), member.points.end());
  }
  return scene;
}

void turn(PlanarTriangles& set, const std::vector<scene::FaceId>& triangles) {
  for (const scene::FaceId triangle : triangles) {
    std::swap(set.members[triangle].points[1], set.members[triangle].points[2]);
    set.members[triangle].along = !set.members[triangle].along;
  }
}

}  // namespace rad::repair
