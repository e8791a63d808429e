// Finding the nearest triangle along a ray.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "bake/scene_triangles.h"

namespace rad::bake {

enum class BackFaces : std::uint8_t { Seen, SeenThrough };

struct RayHit {
  std::uint32_t triangle = 0;
  double u = 0, v = 0;  ///< the point is (1 - u - v) · corner 0 + u · corner 1 + v · corner 2
  double distance = 0;  ///< file units
  bool from_behind = false;
};

/// The triangles of a scene, ready for rays. Built and queried in a fixed order: the same answers whatever the number
/// of threads.
class RayScene {
 public:
  RayScene(const scene::Scene& scene, std::span<const DrawnTriangle> triangles, BackFaces back_faces);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// The nearest triangle from `origin`, file units, along `direction`, of any length but zero. May be called from
  /// several threads at once.
  [[nodiscard]] std::optional<RayHit> nearest(const geom::dvec3& origin, const geom::dvec3& direction) const;

 private:
  struct Rays;
  std::unique_ptr<Rays> rays_;
};

}  // namespace rad::bake
