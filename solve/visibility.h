// Which segments are blocked by the faces of a mesh. The one place that names Embree.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "mesh/radiosity_mesh.h"

namespace rad::solve {

using geom::dvec3;

struct Segment {
  dvec3 from;
  dvec3 to;
};

/// All patches as occluders, from both sides. Segments may end as near to a patch as lift_of(mesh).
class Visibility {
 public:
  /// Throws std::runtime_error where the tracer cannot be set up: memory or an unusable library.
  explicit Visibility(const mesh::RadiosityMesh& mesh);
  ~Visibility();
  Visibility(const Visibility&) = delete;
  Visibility& operator=(const Visibility&) = delete;

  /// `blocked[i]` becomes 1 where a patch meets segments[i] and 0 elsewhere. May be called from many threads.
  void trace(std::span<const Segment> segments, std::span<std::uint8_t> blocked) const;

 private:
  struct Tracer;
  std::unique_ptr<Tracer> tracer_;
};

}  // namespace rad::solve
