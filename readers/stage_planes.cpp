#include "readers/stage_planes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

namespace rad::readers {
namespace {

using geom::dvec3;
using scene::StageFace;
using scene::StagePlane;
using scene::StageRecord;
using scene::VertexId;

// Corners stray from their plane by the band of its leader and by what later cures move; beyond this many T they are of
// another plane.
constexpr double kFarthestFromPlane = 16;
// Work is done at T or a little more (the ladder of repair ends at 1.4 T).
constexpr double kLargestWorkShare = 2;
constexpr double kUnitLength = 1e-6;

class Fit {
 public:
  Fit(const StageRecord& record, double tolerance)
      : record_(record), reach_(kFarthestFromPlane * tolerance), tolerance_(tolerance) {}

  [[nodiscard]] bool holds() const {
    return numbers_hold() && points_differ() &&
           std::ranges::all_of(record_.faces,
                               [&](const StageFace& face) { return corners_are_near(face) && triangles_hold(face); }) &&
           (!record_.overlaps_resolved || edges_differ());
  }

 private:
  [[nodiscard]] dvec3 place(VertexId id) const { return geom::as_vector(record_.points[id]); }
  [[nodiscard]] bool is_near(const StagePlane& plane, VertexId id) const {
    return std::abs(glm::dot(plane.normal, place(id)) - plane.offset) <= reach_;
  }

  [[nodiscard]] bool numbers_hold() const {
    return record_.work_tolerance >= 1 && record_.work_tolerance <= kLargestWorkShare * tolerance_ &&
           std::ranges::all_of(record_.planes, [](const StagePlane& plane) {
             return std::abs(glm::length(plane.normal) - 1) <= kUnitLength && std::isfinite(plane.offset) &&
                    std::isfinite(plane.area) && plane.area >= 0;
           });
  }

  [[nodiscard]] bool points_differ() const {
    std::vector<geom::LatticePoint> sorted = record_.points;
    std::ranges::sort(sorted);
    return std::ranges::adjacent_find(sorted) == sorted.end();
  }

  [[nodiscard]] bool corners_are_near(const StageFace& face) const {
    return std::ranges::all_of(record_.loops_of(face), [&](const scene::Loop& loop) {
      return std::ranges::all_of(record_.corners_of(loop),
                                 [&](VertexId corner) { return is_near(record_.planes[face.plane], corner); });
    });
  }

  // Facing is asked of the projection along the longest axis of the normal, as the plane maps of repair ask it: the
  // normal of a sliver may itself point anywhere. Whole numbers below 2^50, exact.
  [[nodiscard]] bool triangles_hold(const StageFace& face) const {
    const StagePlane& plane = record_.planes[face.plane];
    if (record_.overlaps_resolved && face.triangles.empty()) return false;
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
      if (std::abs(plane.normal[k]) > std::abs(plane.normal[axis])) axis = k;
    }
    return std::ranges::all_of(face.triangles, [&](const auto& corners) {
      const dvec3 normal = glm::cross(place(corners[1]) - place(corners[0]), place(corners[2]) - place(corners[0]));
      const double facing = (face.along ? 1 : -1) * (plane.normal[axis] < 0 ? -1 : 1) * normal[axis];
      return std::ranges::all_of(corners, [&](VertexId corner) { return is_near(plane, corner); }) &&
             (!record_.overlaps_resolved || facing > 0);
    });
  }

  [[nodiscard]] bool edges_differ() const {
    std::vector<std::tuple<std::uint32_t, bool, VertexId, VertexId>> edges;
    for (const StageFace& face : record_.faces) {
      for (const auto& corners : face.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
          edges.emplace_back(face.plane, face.along, corners[k], corners[(k + 1) % 3]);
        }
      }
    }
    std::ranges::sort(edges);
    return std::ranges::adjacent_find(edges) == edges.end();
  }

  const StageRecord& record_;
  double reach_;
  double tolerance_;
};

}  // namespace

bool planes_fit(const StageRecord& record, double tolerance) { return Fit(record, tolerance).holds(); }

}  // namespace rad::readers
