#include "readers/stage_planes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

namespace rad::readers {
namespace {

using geom::dvec3;
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
  Fit(const scene::Scene& scene, const StageRecord& record, double tolerance)
      : scene_(scene), record_(record), reach_(kFarthestFromPlane * tolerance), tolerance_(tolerance) {}

  bool holds() const {
    return numbers_hold() && points_differ() && corners_are_near() && (record_.triangles.empty() || triangles_hold());
  }

 private:
  [[nodiscard]] dvec3 place(VertexId id) const { return geom::as_vector(record_.points[id]); }
  [[nodiscard]] bool is_near(const StagePlane& plane, VertexId id) const {
    return std::abs(glm::dot(plane.normal, place(id)) - plane.offset) <= reach_;
  }

  [[nodiscard]] bool numbers_hold() const {
    const bool work_fits = record_.work_tolerance >= 1 && record_.work_tolerance <= kLargestWorkShare * tolerance_;
    return work_fits && record_.faces.size() == scene_.faces.size() &&
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

  [[nodiscard]] bool corners_are_near() const {
    for (std::size_t id = 0; id < scene_.faces.size(); ++id) {
      const StagePlane& plane = record_.planes[record_.faces[id].plane];
      for (const scene::Loop& loop : scene_.loops_of(scene_.faces[id])) {
        const auto corners = scene_.corners_of(loop);
        if (!std::ranges::all_of(corners, [&](VertexId corner) { return is_near(plane, corner); })) return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool triangles_hold() const {
    if (record_.triangles.size() != scene_.faces.size()) return false;
    std::vector<std::tuple<std::uint32_t, bool, VertexId, VertexId>> edges;
    for (std::size_t id = 0; id < scene_.faces.size(); ++id) {
      const scene::StageFace& face = record_.faces[id];
      const StagePlane& plane = record_.planes[face.plane];
      if (record_.triangles[id].empty()) return false;
      for (const auto& corners : record_.triangles[id]) {
        const dvec3 normal =
            glm::cross(place(corners[1]) - place(corners[0]), place(corners[2]) - place(corners[0]));
        const double facing = (face.along ? 1 : -1) * glm::dot(normal, plane.normal);
        if (!(facing > 0)) return false;
        for (std::size_t k = 0; k < 3; ++k) {
          if (!is_near(plane, corners[k])) return false;
          edges.emplace_back(face.plane, face.along, corners[k], corners[(k + 1) % 3]);
        }
      }
    }
    std::ranges::sort(edges);
    return std::ranges::adjacent_find(edges) == edges.end();
  }

  const scene::Scene& scene_;
  const StageRecord& record_;
  double reach_;
  double tolerance_;
};

}  // namespace

bool planes_fit(const scene::Scene& scene, const StageRecord& record, double tolerance) {
  return Fit(scene, record, tolerance).holds();
}

}  // namespace rad::readers
