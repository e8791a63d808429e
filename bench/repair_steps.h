// Two steps of the Grouper alone.
#pragma once

#include "scene/scene.h"

namespace rad::bench {

/// CPU seconds. Zero where the scene has no tolerance.
struct StepTimes {
  std::size_t corners = 0;
  double weld = 0;  ///< of the corners of all faces, each a point of its own, at T
  std::size_t triangles = 0;
  double insert = 0;       ///< of T-vertices, into a complex that is there already
  std::size_t splits = 0;  ///< edges divided by it
};

/// Welds the corners of `scene`; then inserts the T-vertices among its triangles as they are.
StepTimes time_steps(const scene::Scene& scene);

}  // namespace rad::bench
