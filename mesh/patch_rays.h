// What lies along a ray: the nearest patch, or any.
#pragma once

#include <memory>
#include <optional>

#include "mesh/element_mesh.h"

namespace rad::mesh {

struct PatchHit {
  PatchId patch = 0;
  double distance = 0;  ///< pitches
};

/// The patches of an element mesh, seen from both sides. Places are lattice coordinates. Built in a fixed order and
/// asked by single rays: the same answers whatever the number of threads.
class PatchRays {
 public:
  /// Throws std::bad_alloc where the tracer cannot be set up.
  explicit PatchRays(const ElementMesh& mesh);
  ~PatchRays();
  PatchRays(const PatchRays&) = delete;
  PatchRays& operator=(const PatchRays&) = delete;

  /// `direction` has unit length. May be called from several threads at once.
  [[nodiscard]] std::optional<PatchHit> nearest(const dvec3& from, const dvec3& direction) const;

  /// Whether a patch lies across the first `length` pitches. `direction` has unit length.
  [[nodiscard]] bool blocked(const dvec3& from, const dvec3& direction, double length) const;

 private:
  struct Tracer;
  std::unique_ptr<Tracer> tracer_;
};

}  // namespace rad::mesh
