#include "scene/repaired_scene.h"

namespace rad::scene {
namespace {

class SceneOfModel {
 public:
  SceneOfModel(const ConformingModel& model, const Scene& origin, const std::vector<bool>& as_triangles)
      : model_(model),
        origin_(origin),
        as_triangles_(as_triangles),
        vertex_of_point_(model.points.size(), kNoVertex) {
    result_.scene = without_geometry(origin);
    result_.scene.recorded = RecordedLattice{model.lattice, model.tolerance.length};
  }

  PiecesOfModel take(bool all_points) {
    add_vertices(all_points);
    for (std::uint32_t id = 0; id < model_.faces.size(); ++id) add_face(id);
    return std::move(result_);
  }

 private:
  static constexpr VertexId kNoVertex = 0xffffffffu;

  void add_vertices(bool all_points) {
    std::vector<bool> used(model_.points.size(), all_points);
    for (std::uint32_t id = 0; id < model_.faces.size(); ++id) {
      const ConformingFace& face = model_.faces[id];
      if (as_triangles_[id]) {
        for (const auto& triangle : model_.triangles_of(face)) {
          for (const PointId point : triangle) used[point] = true;
        }
      } else {
        for (const Loop& loop : model_.loops_of(face)) {
          for (const PointId point : model_.corners_of(loop)) used[point] = true;
        }
      }
    }
    for (PointId point = 0; point < model_.points.size(); ++point) {
      if (!used[point]) continue;
      vertex_of_point_[point] = static_cast<VertexId>(result_.scene.vertices.size());
      result_.scene.vertices.push_back(model_.lattice.position(model_.points[point]));
    }
  }

  void add_face(std::uint32_t id) {
    const ConformingFace& face = model_.faces[id];
    if (!as_triangles_[id]) {
      open_face(id, PiecesOfModel::kWhole, face.source);
      for (const Loop& loop : model_.loops_of(face)) add_loop(model_.corners_of(loop));
      return;
    }
    for (std::uint32_t i = 0; i < face.triangle_count; ++i) {
      const std::uint32_t triangle = face.first_triangle + i;
      open_face(id, triangle, model_.origins.empty() ? face.source : model_.origins[triangle].source);
      add_loop(model_.triangles[triangle]);
    }
  }

  void open_face(std::uint32_t id, std::uint32_t triangle, FaceId from) {
    const ConformingFace& face = model_.faces[id];
    const SourceRef source = from < origin_.faces.size() ? origin_.faces[from].source : SourceRef{};
    result_.scene.faces.push_back({.first_loop = static_cast<std::uint32_t>(result_.scene.loops.size()),
                                   .loop_count = 0,
                                   .material = face.material,
                                   .object = face.object,
                                   .group = face.group,
                                   .source = source});
    result_.face.push_back(id);
    result_.triangle.push_back(triangle);
  }

  void add_loop(std::span<const PointId> points) {
    Scene& scene = result_.scene;
    scene.loops.push_back(
        {static_cast<std::uint32_t>(scene.corners.size()), static_cast<std::uint32_t>(points.size())});
    for (const PointId point : points) scene.corners.push_back(vertex_of_point_[point]);
    ++scene.faces.back().loop_count;
  }

  const ConformingModel& model_;
  const Scene& origin_;
  const std::vector<bool>& as_triangles_;
  PiecesOfModel result_;
  std::vector<VertexId> vertex_of_point_;
};

}  // namespace

Scene repaired_scene(const ConformingModel& model, const Scene& origin, Pieces pieces) {
  const std::vector<bool> as_triangles(model.faces.size(), pieces == Pieces::Triangles);
  return SceneOfModel(model, origin, as_triangles).take(pieces == Pieces::FacesAndAllPoints).scene;
}

PiecesOfModel pieces_of(const ConformingModel& model, const Scene& origin, const std::vector<bool>& as_triangles) {
  return SceneOfModel(model, origin, as_triangles).take(false);
}

}  // namespace rad::scene
