// Normal consistency (1b): neighbours are made to look one way, closed objects outward (paper 2.1).
#pragma once

#include <vector>

#include "scene/scene.h"
#include "validate/context.h"

namespace rad::repair {

/// Faces to turn, ascending. Neighbours (validate/neighbours.h) are made to agree: of a set that can agree the smaller
/// part by area turns. Then objects that lint calls inside out (RL104) turn; then what light proves to be turned over
/// (RL112), which needs a conforming model. A set that cannot agree, a one-sided surface, is left as it is.
std::vector<scene::FaceId> faces_to_turn(const validate::Context& context);

/// The scene with these faces turned: each of their loops runs backward from the same first corner, and
/// their normals are negated.
scene::Scene turned(scene::Scene scene, const std::vector<scene::FaceId>& faces);

struct Oriented {
  std::vector<scene::FaceId> turned;         ///< ascending
  std::optional<validate::Context> context;  ///< of the scene as it is now, where it was built
};

/// Turns until lint sees no fault of orientation that turning would cure. The context refers to `scene`.
Oriented orient(scene::Scene& scene, const scene::ReadIssues& issues,
                const std::optional<geom::ToleranceRequest>& tolerance);

}  // namespace rad::repair
