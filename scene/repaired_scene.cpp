#include "scene/repaired_scene.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "scene/attribute_transfer.h"
#include "scene/attribute_writer.h"

namespace rad::scene {
namespace {

/// Gives triangles and polygons of the model what their corners have, in the order in which they are added.
class ModelAttributes {
 public:
  ModelAttributes(const ConformingModel& model, const Scene& origin, CornerAttributes& attributes)
      : model_(model),
        transfer_(model, origin),
        writer_(attributes, origin.attributes.texture_origin),
        best_of_point_(model.points.size(), kNone) {}

  void add_triangle(std::size_t triangle) {
    std::array<CornerValue, 3> values;
    for (std::size_t k = 0; k < 3; ++k) values[k] = transfer_.value(triangle, k);
    writer_.add(values);
  }

  // At each corner the first triangle counts to which the corner is one of its source face, else the first of all.
  void add_polygon(const ConformingFace& face) {
    const std::size_t first = 3 * std::size_t{face.first_triangle}, last = first + 3 * std::size_t{face.triangle_count};
    for (std::size_t corner = first; corner < last; ++corner) {
      std::size_t& best = best_of_point_[point_of(corner)];
      const bool is_better = best == kNone || (!value_at(best).kept && value_at(corner).kept);
      if (is_better) best = corner;
    }
    std::vector<CornerValue> values;
    for (const Loop& loop : model_.loops_of(face)) {
      for (const PointId point : model_.corners_of(loop)) values.push_back(value_at(best_of_point_[point]));
    }
    for (std::size_t corner = first; corner < last; ++corner) best_of_point_[point_of(corner)] = kNone;
    writer_.add(values);
  }

  void finish() { writer_.finish(); }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  [[nodiscard]] PointId point_of(std::size_t corner) const { return model_.triangles[corner / 3][corner % 3]; }
  [[nodiscard]] CornerValue value_at(std::size_t corner) const { return transfer_.value(corner / 3, corner % 3); }

  const ConformingModel& model_;
  AttributeTransfer transfer_;
  AttributeWriter writer_;
  std::vector<std::size_t> best_of_point_;  ///< of the face that is added: a corner of a triangle, counted over all
};

class SceneOfModel {
 public:
  SceneOfModel(const ConformingModel& model, const Scene& origin, const std::vector<bool>& as_triangles)
      : model_(model), origin_(origin), as_triangles_(as_triangles), vertex_of_point_(model.points.size(), kNoVertex) {
    result_.scene = without_geometry(origin);
    result_.scene.recorded = RecordedLattice{model.lattice, model.tolerance.length};
    if (!origin.attributes.empty()) attributes_.emplace(model, origin, result_.scene.attributes);
  }

  PiecesOfModel take() {
    add_vertices();
    if (std::ranges::find(as_triangles_, false) == as_triangles_.end()) {
      add_triangles_by_place();
    } else {
      for (std::uint32_t id = 0; id < model_.faces.size(); ++id) add_face(id);
    }
    if (attributes_) attributes_->finish();
    return std::move(result_);
  }

 private:
  static constexpr VertexId kNoVertex = 0xffffffffu;

  void add_vertices() {
    std::vector<bool> used(model_.points.size(), false);
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

  // Which triangles were put together to one face hangs on the faces that they came from, and a second run sees
  // triangles where the first saw polygons: so the order is that of space.
  void add_triangles_by_place() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> placed;
    placed.reserve(model_.triangles.size());
    for (std::uint32_t id = 0; id < model_.faces.size(); ++id) {
      const ConformingFace& face = model_.faces[id];
      for (std::uint32_t i = 0; i < face.triangle_count; ++i) placed.emplace_back(face.first_triangle + i, id);
    }
    std::ranges::stable_sort(placed, {}, [&](const auto& entry) {
      const ConformingFace& face = model_.faces[entry.second];
      return std::tuple(model_.triangles[entry.first], face.material, face.object, face.group);
    });
    for (const auto& [triangle, id] : placed) add_triangle(id, triangle);
  }

  void add_face(std::uint32_t id) {
    const ConformingFace& face = model_.faces[id];
    if (as_triangles_[id]) {
      for (std::uint32_t i = 0; i < face.triangle_count; ++i) add_triangle(id, face.first_triangle + i);
      return;
    }
    open_face(id, PiecesOfModel::kWhole, face.source);
    for (const Loop& loop : model_.loops_of(face)) add_loop(model_.corners_of(loop));
    if (attributes_) attributes_->add_polygon(face);
  }

  void add_triangle(std::uint32_t id, std::uint32_t triangle) {
    open_face(id, triangle, model_.origins.empty() ? model_.faces[id].source : model_.origins[triangle].source);
    add_loop(model_.triangles[triangle]);
    if (attributes_) attributes_->add_triangle(triangle);
  }

  void open_face(std::uint32_t id, std::uint32_t triangle, FaceId from) {
    const ConformingFace& face = model_.faces[id];
    if (face.source < origin_.smoothing_groups.size()) {
      result_.scene.smoothing_groups.push_back(origin_.smoothing_groups[face.source]);
    }
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
  std::optional<ModelAttributes> attributes_;  ///< where the origin has any
};

}  // namespace

Scene repaired_scene(const ConformingModel& model, const Scene& origin, Pieces pieces) {
  const std::vector<bool> as_triangles(model.faces.size(), pieces == Pieces::Triangles);
  return SceneOfModel(model, origin, as_triangles).take().scene;
}

PiecesOfModel pieces_of(const ConformingModel& model, const Scene& origin, const std::vector<bool>& as_triangles) {
  return SceneOfModel(model, origin, as_triangles).take();
}

}  // namespace rad::scene
