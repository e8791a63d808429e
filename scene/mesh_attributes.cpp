#include "scene/mesh_attributes.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "scene/attribute_transfer.h"
#include "scene/attribute_writer.h"
#include "scene/triangle_shares.h"

namespace rad::scene {
namespace {

/// A triangle of the model with what its corners have.
struct ValuedTriangle {
  std::array<dvec3, 3> place;
  dvec3 low;
  dvec3 high;
  std::array<CornerValue, 3> value;

  /// A lower bound of the distance to a point.
  [[nodiscard]] double least_distance(const dvec3& point) const {
    return glm::distance(glm::clamp(point, low, high), point);
  }
};

CornerValue blend_values(const std::array<CornerValue, 3>& value, const std::array<double, 3>& share) {
  CornerValue result;
  if (std::ranges::all_of(value, [](const CornerValue& v) { return v.texture_coordinates.has_value(); })) {
    result.texture_coordinates = blend(
        std::array{*value[0].texture_coordinates, *value[1].texture_coordinates, *value[2].texture_coordinates}, share);
  }
  if (std::ranges::all_of(value, [](const CornerValue& v) { return v.normal.has_value(); })) {
    const dvec3 sum = blend(std::array{*value[0].normal, *value[1].normal, *value[2].normal}, share);
    // At a corner the normal stays as it is.
    const bool is_corner = std::ranges::find(share, 1.0) != share.end();
    if (is_corner || glm::length(sum) > 0) result.normal = is_corner ? sum : glm::normalize(sum);
  }
  return result;
}

/// The triangles of one face of the model.
class ValuedFace {
 public:
  ValuedFace(const ConformingModel& model, const ConformingFace& face, const AttributeTransfer& transfer) {
    for (std::uint32_t i = face.first_triangle; i < face.first_triangle + face.triangle_count; ++i) {
      ValuedTriangle triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.place[k] = model.lattice.position(model.points[model.triangles[i][k]]);
        triangle.value[k] = transfer.value(i, k);
      }
      triangle.low = glm::min(triangle.place[0], glm::min(triangle.place[1], triangle.place[2]));
      triangle.high = glm::max(triangle.place[0], glm::max(triangle.place[1], triangle.place[2]));
      triangles_.push_back(triangle);
    }
  }

  // Among triangles that are equally near the first counts; they stand in an order of space.
  [[nodiscard]] CornerValue at(const dvec3& point) const {
    const ValuedTriangle* nearest = nullptr;
    std::array<double, 3> share_there{};
    double least = 0;
    for (const ValuedTriangle& triangle : triangles_) {
      if (nearest != nullptr && triangle.least_distance(point) >= least) continue;
      const std::array<double, 3> share = nearest_shares(triangle.place, point);
      const double distance = glm::distance(blend(triangle.place, share), point);
      if (nearest != nullptr && distance >= least) continue;
      nearest = &triangle;
      share_there = share;
      least = distance;
    }
    return nearest == nullptr ? CornerValue{} : blend_values(nearest->value, share_there);
  }

 private:
  std::vector<ValuedTriangle> triangles_;
};

}  // namespace

void carry_attributes(Scene& mesh, std::span<const std::uint32_t> model_face, const ConformingModel& model,
                      const Scene& origin) {
  if (origin.attributes.empty()) return;
  const AttributeTransfer transfer(model, origin);
  AttributeWriter writer(mesh.attributes, origin.attributes.texture_origin);
  std::optional<ValuedFace> valued;
  std::vector<CornerValue> values;
  for (FaceId id = 0; id < mesh.faces.size(); ++id) {
    const bool is_next = id == 0 || model_face[id] != model_face[id - 1];
    if (is_next) valued.emplace(model, model.faces[model_face[id]], transfer);
    values.clear();
    for (const Loop& loop : mesh.loops_of(mesh.faces[id])) {
      for (const VertexId vertex : mesh.corners_of(loop)) values.push_back(valued->at(mesh.vertices[vertex]));
    }
    writer.add(values);
  }
  writer.finish();
}

}  // namespace rad::scene
