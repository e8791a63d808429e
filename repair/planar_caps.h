// Caps on request (--cap-planar): flat openings of open surfaces are closed with a face.
#pragma once

#include <optional>

#include "geom/tolerance.h"
#include "scene/read_issue.h"
#include "scene/scene.h"

namespace rad::repair {

struct Capped {
  scene::Scene scene;
  std::size_t caps = 0;
};

/// The scene with a face in every opening whose border lies within T of a plane: a closed chain of edges that one face
/// of its component uses. A border inside of another in the same plane, running the other way, becomes a hole of its
/// cap. The cap continues the faces around it, so that all look the same way, and is of their object and material
/// (that of the largest of them), without texture coordinates. The outer border of a flat sheet, which a cap would
/// double, and borders that branch or touch themselves are left open.
Capped with_planar_caps(scene::Scene scene, const scene::ReadIssues& issues,
                        const std::optional<geom::ToleranceRequest>& tolerance);

}  // namespace rad::repair
