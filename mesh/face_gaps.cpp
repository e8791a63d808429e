#include "mesh/face_gaps.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "geom/segment_distance.h"
#include "geom/vec.h"
#include "mesh/edge_sizes.h"
#include "mesh/face_frame.h"

namespace rad::mesh {
namespace {

// A part may become half as long again as its size, so that a patch at the shortest edge is at most 2.25 times as long
// as wide: ρ = 0.57 as a rectangle.
constexpr double kShortEdgeShare = 1.5;

// With parts half as long again as their size, patches across a strip are at most 2.1 times as long as wide: ρ = 0.61.
constexpr double kGapShare = 1.4;

class GapFinder {
 public:
  GapFinder(const scene::ConformingModel& model, const scene::ConformingFace& face, const FaceOutline& outline,
            const EdgeDivision& division)
      : model_(model), outline_(outline), division_(division), frame_(model, face) {
    for (const scene::Loop& loop : model.loops_of(face)) {
      const auto ring = model.corners_of(loop);
      for (std::size_t i = 0; i < ring.size(); ++i) add_edge(ring[i], ring[(i + 1) % ring.size()]);
    }
    for (const auto& edge : model.inner_edges_of(face)) add_edge(edge[0], edge[1]);
    std::sort(edges_.begin(), edges_.end());
  }

  FaceGaps run() {
    std::vector<geom::PlanarPoint> flat;
    for (const PointId id : outline_.ids) flat.push_back(frame_.flat(division_.points()[id]));
    for (const auto& triangle : geom::triangulate_region(flat, outline_.outline, outline_.inner)) {
      for (std::size_t i = 0; i < 3; ++i) {
        const PointId a = outline_.ids[triangle.corners[i]], b = outline_.ids[triangle.corners[(i + 1) % 3]];
        const PointId apex = outline_.ids[triangle.corners[(i + 2) % 3]];
        if (triangle.boundary[i]) {
          note(a, b, apex);
        } else if (a < b) {
          gaps_.across.push_back({a, b});
        }
      }
    }
    return std::move(gaps_);
  }

 private:
  void add_edge(PointId a, PointId b) { edges_.push_back({std::min(a, b), std::max(a, b)}); }

  [[nodiscard]] bool in_model(PointId point) const { return point < model_.points.size(); }
  [[nodiscard]] bool joined(PointId a, PointId b) const {
    return a == b || std::binary_search(edges_.begin(), edges_.end(), PointPair{std::min(a, b), std::max(a, b)});
  }

  // The ends of the undivided edge that two neighbouring points lie on.
  [[nodiscard]] EdgeKey edge_under(PointId a, PointId b) const {
    if (!in_model(a)) return division_.ends(division_.edge_of(a));
    return in_model(b) ? EdgeKey{a, b} : division_.ends(division_.edge_of(b));
  }

  [[nodiscard]] bool meets(PointId point, const EdgeKey& edge) const {
    if (in_model(point)) return joined(point, edge[0]) || joined(point, edge[1]);
    const EdgeKey& own = division_.ends(division_.edge_of(point));
    return own[0] == edge[0] || own[0] == edge[1] || own[1] == edge[0] || own[1] == edge[1];
  }

  void note(PointId a, PointId b, PointId apex) {
    if (meets(apex, edge_under(a, b))) return;
    const auto at = [&](PointId point) { return geom::as_vector(division_.points()[point]); };
    const double gap = geom::distance_to_segment(at(apex), at(a), at(b));
    gaps_.near.push_back({apex, kGapShare * gap});
    for (const PointId end : {a, b}) {
      const double way = glm::length(at(end) - at(apex));
      gaps_.near.push_back({end, kGapShare * gap + kSizeSlope * std::max(0.0, way - gap)});
    }
  }

  const scene::ConformingModel& model_;
  const FaceOutline& outline_;
  const EdgeDivision& division_;
  FaceFrame frame_;
  std::vector<PointPair> edges_;  ///< of the face, undivided; ascending
  FaceGaps gaps_;
};

// Its edges all meet each other.
bool is_triangle(const scene::ConformingModel& model, const scene::ConformingFace& face) {
  return face.loop_count == 1 && model.loops_of(face)[0].count == 3 && face.inner_edge_count == 0 &&
         face.triangle_count == 1;
}

// A triangle with a corner this sharp is as thin in any division: its short edge asks for nothing.
constexpr double kNeedleCosine = 0.8660254037844386;  // 30 degrees

bool is_needle(const scene::ConformingModel& model, std::span<const PointId> ring) {
  double sharpest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = [&](std::size_t k) { return geom::as_vector(model.points[ring[k % 3]]); };
    sharpest = std::max(sharpest, glm::dot(glm::normalize(at(i + 1) - at(i)), glm::normalize(at(i + 2) - at(i))));
  }
  return sharpest > kNeedleCosine;
}

void add_short_edges(const scene::ConformingModel& model, const scene::ConformingFace& face, FaceGaps& gaps) {
  const auto add = [&](PointId a, PointId b) {
    const double length = glm::length(geom::as_vector(model.points[b]) - geom::as_vector(model.points[a]));
    for (const PointId end : {a, b}) gaps.near.push_back({end, kShortEdgeShare * length});
  };
  for (const scene::Loop& loop : model.loops_of(face)) {
    const auto ring = model.corners_of(loop);
    if (is_triangle(model, face) && is_needle(model, ring)) return;
    for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()]);
  }
  for (const auto& edge : model.inner_edges_of(face)) add(edge[0], edge[1]);
}

}  // namespace

FaceGaps face_gaps(const scene::ConformingModel& model, const scene::ConformingFace& face, const FaceOutline& outline,
                   const EdgeDivision& division) {
  if (outline.ids.empty()) return {};
  FaceGaps gaps = is_triangle(model, face) ? FaceGaps{} : GapFinder(model, face, outline, division).run();
  add_short_edges(model, face, gaps);
  return gaps;
}

}  // namespace rad::mesh
