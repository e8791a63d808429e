#include "scene/attribute_transfer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "scene/face_map.h"

namespace rad::scene {
namespace {

// In T: the farthest that repair moves a vertex (docs/repair.md: 4 T, 8 T where points are merged).
constexpr double kFarthestMove = 8;
// Shorter than this a blend of unit normals has no direction.
constexpr double kLeastNormal = 1e-6;

constexpr CornerId kNoCorner = 0xffffffffu;

/// Where the corners of one source face went among the points of its triangles.
class KeptCorners {
 public:
  KeptCorners(const ConformingModel& model, const Scene& origin, std::vector<PointId> points)
      : model_(model),
        origin_(origin),
        points_(std::move(points)),
        corner_(points_.size(), kNoCorner),
        distance_(points_.size(), 0) {}

  void place_all(const Face& face) {
    for (const Loop& loop : origin_.loops_of(face)) {
      for (CornerId corner = loop.first; corner < loop.first + loop.count; ++corner) place(corner);
    }
  }

  [[nodiscard]] std::size_t index_of(PointId point) const {
    return static_cast<std::size_t>(std::lower_bound(points_.begin(), points_.end(), point) - points_.begin());
  }
  /// kNoCorner where no corner went there.
  [[nodiscard]] CornerId corner_at(std::size_t index) const { return corner_[index]; }
  [[nodiscard]] const std::vector<PointId>& points() const { return points_; }

 private:
  // Points of a model stand in the order of space, so that those near a place lie in one stretch.
  void place(CornerId corner) {
    const geom::LatticePoint wanted = model_.lattice.nearest(origin_.vertices[origin_.corners[corner]]);
    const auto at_or_after = [&](std::int64_t x) {
      return std::ranges::partition_point(points_, [&](PointId id) { return model_.points[id].x < x; });
    };
    const auto exact = std::ranges::lower_bound(points_, wanted, {}, [&](PointId id) { return model_.points[id]; });
    if (exact != points_.end() && model_.points[*exact] == wanted) return take(exact, corner, 0);
    const double reach = kFarthestMove * static_cast<double>(model_.tolerance.pitches);
    const auto reach_in_pitches = static_cast<std::int64_t>(reach);
    auto nearest = points_.end();
    double least = reach;
    for (auto at = at_or_after(wanted.x - reach_in_pitches); at != points_.end(); ++at) {
      if (model_.points[*at].x > wanted.x + reach_in_pitches) break;
      const double distance = glm::distance(geom::as_vector(model_.points[*at]), geom::as_vector(wanted));
      if (distance > least || (distance == least && nearest != points_.end())) continue;
      nearest = at;
      least = distance;
    }
    if (nearest != points_.end()) take(nearest, corner, least);
  }

  // Of several corners that went to one point the nearest counts, then the first in space.
  void take(std::vector<PointId>::const_iterator point, CornerId corner, double distance) {
    const auto index = static_cast<std::size_t>(point - points_.begin());
    const CornerId known = corner_[index];
    if (known != kNoCorner &&
        (distance > distance_[index] || (distance == distance_[index] && !comes_before(corner, known)))) {
      return;
    }
    corner_[index] = corner;
    distance_[index] = distance;
  }

  [[nodiscard]] bool comes_before(CornerId a, CornerId b) const {
    const dvec3 &p = origin_.vertices[origin_.corners[a]], &q = origin_.vertices[origin_.corners[b]];
    if (p.x != q.x) return p.x < q.x;
    return p.y != q.y ? p.y < q.y : p.z < q.z;
  }

  const ConformingModel& model_;
  const Scene& origin_;
  std::vector<PointId> points_;   ///< ascending
  std::vector<CornerId> corner_;  ///< per point
  std::vector<double> distance_;  ///< of that corner, pitches
};

std::vector<PointId> points_of(const ConformingModel& model, std::span<const std::uint32_t> triangles) {
  std::vector<PointId> points;
  for (const std::uint32_t triangle : triangles) {
    points.insert(points.end(), model.triangles[triangle].begin(), model.triangles[triangle].end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

template <typename Value>
Value blend(const CornerValues<Value>& values, const FacePlace& place) {
  Value sum(0.0);
  for (std::size_t i = 0; i < 3; ++i) sum += values.table[values.row(place.corner[i])] * place.share[i];
  return sum;
}

template <typename Value>
bool has(const CornerValues<Value>& values, const Scene& scene, const Face& face) {
  const Loop& outer = scene.loops[face.first_loop];
  return outer.count > 0 && values.row(outer.first) != kNoRow;
}

}  // namespace

AttributeTransfer::AttributeTransfer(const ConformingModel& model, const Scene& origin)
    : model_(model), origin_(origin) {
  const std::size_t corners = 3 * model.triangles.size();
  if (!origin.attributes.texture_coordinates.empty()) texture_coordinates_.assign(corners, dvec2(kNone));
  if (!origin.attributes.normals.empty()) normals_.assign(corners, dvec3(kNone));
  kept_.assign(corners, false);
  if (origin.attributes.empty() || model.origins.empty()) return;
  std::vector<std::uint32_t> order(model.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto source = [&](std::uint32_t triangle) { return model.origins[triangle].source; };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return source(a) < source(b); });
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && source(order[last]) == source(order[first])) ++last;
    transfer_face(origin.faces[source(order[first])], std::span(order).subspan(first, last - first));
  }
}

void AttributeTransfer::transfer_face(const Face& face, std::span<const std::uint32_t> triangles) {
  const CornerAttributes& from = origin_.attributes;
  const bool textured = has(from.texture_coordinates, origin_, face), shaded = has(from.normals, origin_, face);
  if (!textured && !shaded) return;
  const FaceMap map(origin_, face, model_.lattice);
  KeptCorners kept(model_, origin_, points_of(model_, triangles));
  kept.place_all(face);
  std::vector<FacePlace> places;
  places.reserve(kept.points().size());
  for (std::size_t i = 0; i < kept.points().size(); ++i) {
    const CornerId corner = kept.corner_at(i);
    places.push_back(corner != kNoCorner ? FacePlace{{corner, corner, corner}, {1, 0, 0}}
                                         : map.nearest(model_.lattice.position(model_.points[kept.points()[i]])));
  }
  for (const std::uint32_t triangle : triangles) {
    const auto& points = model_.triangles[triangle];
    const auto at = [&](std::size_t k) { return geom::as_vector(model_.points[points[k]]); };
    const dvec3 front = glm::cross(at(1) - at(0), at(2) - at(0));
    const bool turned = glm::dot(front, map.normal()) < 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t index = kept.index_of(points[k]);
      const FacePlace& place = places[index];
      const bool is_kept = kept.corner_at(index) != kNoCorner;
      kept_[3 * triangle + k] = is_kept;
      if (textured) texture_coordinates_[3 * triangle + k] = blend(from.texture_coordinates, place);
      if (!shaded) continue;
      dvec3 normal = blend(from.normals, place);
      const double length = glm::length(normal);
      if (!is_kept) normal = length > kLeastNormal ? normal / length : glm::normalize(turned ? -front : front);
      normals_[3 * triangle + k] = turned ? -normal : normal;
    }
  }
}

CornerValue AttributeTransfer::value(std::size_t triangle, std::size_t corner) const {
  const std::size_t index = 3 * triangle + corner;
  CornerValue value;
  value.kept = kept_[index];
  if (!texture_coordinates_.empty() && !std::isnan(texture_coordinates_[index].x)) {
    value.texture_coordinates = texture_coordinates_[index];
  }
  if (!normals_.empty() && !std::isnan(normals_[index].x)) value.normal = normals_[index];
  return value;
}

}  // namespace rad::scene
