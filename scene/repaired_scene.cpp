#include "scene/repaired_scene.h"

#include <algorithm>
#include <optional>
#include <utility>

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
  SceneOfModel(const ConformingModel& model, const Scene& origin)
      : model_(model),
        origin_(origin),
        scene_(without_geometry(origin)),
        vertex_of_point_(model.points.size(), kNoVertex) {
    scene_.recorded = RecordedLattice{model.lattice, model.tolerance.length};
    if (!origin.attributes.empty()) attributes_.emplace(model, origin, scene_.attributes);
  }

  Scene take(Pieces pieces) {
    add_vertices(pieces);
    if (pieces == Pieces::Triangles) {
      for (const auto& [triangle, face] : triangles_in_order()) add_triangle(triangle, model_.faces[face]);
    } else {
      for (const ConformingFace& face : model_.faces) {
        open_face(face);
        for (const Loop& loop : model_.loops_of(face)) add_loop(model_.corners_of(loop));
        if (attributes_) attributes_->add_polygon(face);
      }
    }
    if (attributes_) attributes_->finish();
    return std::move(scene_);
  }

 private:
  static constexpr VertexId kNoVertex = 0xffffffffu;

  void add_vertices(Pieces pieces) {
    std::vector<bool> used(model_.points.size(), false);
    if (pieces == Pieces::Triangles) {
      for (const auto& triangle : model_.triangles) {
        for (const PointId point : triangle) used[point] = true;
      }
    } else {
      for (const PointId point : model_.corners) used[point] = true;
    }
    for (PointId point = 0; point < model_.points.size(); ++point) {
      if (!used[point]) continue;
      vertex_of_point_[point] = static_cast<VertexId>(scene_.vertices.size());
      scene_.vertices.push_back(model_.lattice.position(model_.points[point]));
    }
  }

  // Triangles with their faces, face by face. With attributes in an order of space instead: which faces were merged
  // hangs on the faces that they came from, and a second run sees triangles where the first saw polygons.
  std::vector<std::pair<std::uint32_t, std::size_t>> triangles_in_order() const {
    std::vector<std::pair<std::uint32_t, std::size_t>> order;
    order.reserve(model_.triangles.size());
    for (std::size_t face = 0; face < model_.faces.size(); ++face) {
      const std::uint32_t first = model_.faces[face].first_triangle;
      for (std::uint32_t i = 0; i < model_.faces[face].triangle_count; ++i) order.emplace_back(first + i, face);
    }
    if (!origin_.attributes.empty()) {
      std::ranges::stable_sort(order, {}, [&](const auto& entry) { return model_.triangles[entry.first]; });
    }
    return order;
  }

  void add_triangle(std::uint32_t triangle, const ConformingFace& face) {
    open_face(face);
    add_loop(model_.triangles[triangle]);
    if (attributes_) attributes_->add_triangle(triangle);
  }

  void open_face(const ConformingFace& face) {
    if (face.source < origin_.smoothing_groups.size()) {
      scene_.smoothing_groups.push_back(origin_.smoothing_groups[face.source]);
    }
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
  std::optional<ModelAttributes> attributes_;  ///< where the origin has any
};

}  // namespace

Scene repaired_scene(const ConformingModel& model, const Scene& origin, Pieces pieces) {
  return SceneOfModel(model, origin).take(pieces);
}

}  // namespace rad::scene
