#include "scene/stage_record.h"

namespace rad::scene {
namespace {

void add_loop(Scene& scene, std::span<const VertexId> corners) {
  scene.loops.push_back({static_cast<std::uint32_t>(scene.corners.size()), static_cast<std::uint32_t>(corners.size())});
  scene.corners.insert(scene.corners.end(), corners.begin(), corners.end());
  ++scene.faces.back().loop_count;
}

void open_face(Scene& scene, const StageFace& face) {
  scene.faces.push_back({.first_loop = static_cast<std::uint32_t>(scene.loops.size()),
                         .loop_count = 0,
                         .material = face.material,
                         .object = face.object,
                         .group = face.group,
                         .source = face.sources.front()});
}

}  // namespace

void StageRecord::add_loop(std::span<const VertexId> points_of_loop) {
  loops.push_back({static_cast<std::uint32_t>(corners.size()), static_cast<std::uint32_t>(points_of_loop.size())});
  corners.insert(corners.end(), points_of_loop.begin(), points_of_loop.end());
  ++faces.back().loop_count;
}

Scene scene_of_stage(const Scene& names, StageRecord record, const RecordedLattice& lattice) {
  Scene scene = without_geometry(names);
  scene.recorded = lattice;
  scene.vertices = record.vertices;
  for (const geom::LatticePoint& point : record.points) scene.vertices.push_back(lattice.lattice.position(point));
  record.face_of.clear();
  for (std::uint32_t id = 0; id < record.faces.size(); ++id) {
    const StageFace& face = record.faces[id];
    for (const auto& triangle : face.triangles) {
      open_face(scene, face);
      add_loop(scene, triangle);
      record.face_of.push_back(id);
    }
    if (!face.triangles.empty()) continue;
    open_face(scene, face);
    for (const Loop& loop : record.loops_of(face)) add_loop(scene, record.corners_of(loop));
    record.face_of.push_back(id);
  }
  scene.triangles_only = !record.planes.empty();
  scene.stage = std::make_shared<const StageRecord>(std::move(record));
  return scene;
}

}  // namespace rad::scene
