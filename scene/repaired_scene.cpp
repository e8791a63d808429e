#include "scene/repaired_scene.h"

#include <algorithm>
#include <tuple>

namespace rad::scene {
namespace {

class SceneOfModel {
 public:
  SceneOfModel(const ConformingModel& model, const Scene& origin)
      : model_(model),
        origin_(origin),
        scene_(without_geometry(origin)),
        vertex_of_point_(model.points.size(), kNoVertex) {
    scene_.recorded = RecordedLattice{model.lattice, model.tolerance.length};
  }

  // In the order of space, whatever faces they are put together to.
  Scene take_triangles() {
    add_vertices(std::vector<bool>(model_.faces.size(), false));
    using Placed = std::tuple<std::array<PointId, 3>, MaterialId, ObjectId, GroupId, FaceId>;
    std::vector<Placed> placed;
    placed.reserve(model_.triangles.size());
    for (FaceId id = 0; id < model_.faces.size(); ++id) {
      const ConformingFace& face = model_.faces[id];
      for (const auto& triangle : model_.triangles_of(face)) {
        placed.emplace_back(triangle, face.material, face.object, face.group, id);
      }
    }
    std::sort(placed.begin(), placed.end());
    for (const Placed& triangle : placed) {
      open_face(model_.faces[std::get<4>(triangle)]);
      add_loop(std::get<0>(triangle));
    }
    return std::move(scene_);
  }

  Scene take(const std::vector<bool>& whole) {
    add_vertices(whole);
    for (std::size_t i = 0; i < model_.faces.size(); ++i) {
      const ConformingFace& face = model_.faces[i];
      if (whole[i]) {
        open_face(face);
        for (const Loop& loop : model_.loops_of(face)) add_loop(model_.corners_of(loop));
      } else {
        for (const auto& triangle : model_.triangles_of(face)) {
          open_face(face);
          add_loop(triangle);
        }
      }
    }
    return std::move(scene_);
  }

 private:
  static constexpr VertexId kNoVertex = 0xffffffffu;

  void add_vertices(const std::vector<bool>& whole) {
    std::vector<bool> used(model_.points.size(), false);
    for (std::size_t i = 0; i < model_.faces.size(); ++i) {
      if (whole[i]) {
        for (const Loop& loop : model_.loops_of(model_.faces[i])) {
          for (const PointId point : model_.corners_of(loop)) used[point] = true;
        }
      } else {
        for (const auto& triangle : model_.triangles_of(model_.faces[i])) {
          for (const PointId point : triangle) used[point] = true;
        }
      }
    }
    for (PointId point = 0; point < model_.points.size(); ++point) {
      if (!used[point]) continue;
      vertex_of_point_[point] = static_cast<VertexId>(scene_.vertices.size());
      scene_.vertices.push_back(model_.lattice.position(model_.points[point]));
    }
  }

  void open_face(const ConformingFace& face) {
    const SourceRef source = face.source < origin_.faces.size() ? origin_.faces[face.source].source : SourceRef{};
    scene_.faces.push_back({.first_loop = static_cast<std::uint32_t>(scene_.loops.size()),
                            .loop_count = 0,
                            .material = face.material,
                            .object = face.object,
                            .group = face.group,
                            .source = source});
  }

  void add_loop(std::span<const PointId> points) {
    scene_.loops.push_back(
        {static_cast<std::uint32_t>(scene_.corners.size()), static_cast<std::uint32_t>(points.size())});
    for (const PointId point : points) scene_.corners.push_back(vertex_of_point_[point]);
    ++scene_.faces.back().loop_count;
  }

  const ConformingModel& model_;
  const Scene& origin_;
  Scene scene_;
  std::vector<VertexId> vertex_of_point_;
};

}  // namespace

Scene repaired_scene(const ConformingModel& model, const Scene& origin, Pieces pieces) {
  if (pieces == Pieces::Triangles) return SceneOfModel(model, origin).take_triangles();
  return repaired_scene(model, origin, std::vector<bool>(model.faces.size(), true));
}

Scene repaired_scene(const ConformingModel& model, const Scene& origin, const std::vector<bool>& whole) {
  return SceneOfModel(model, origin).take(whole);
}

}  // namespace rad::scene
