// Whether a model needs repair: the gate that makes repairing twice the same as repairing once.
#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "repair/maximal_faces.h"
#include "repair/triangle_lint.h"
#include "validate/context.h"
#include "validate/stage.h"

namespace rad::repair {

/// The triangles of a judged scene in the planes that they lie in: those of its faces' triangulations as they are.
PlanarTriangles planar_triangles(const validate::Context& context);

/// What the lint of the triangles finds in them.
std::vector<Violation> violations_of(const PlanarTriangles& triangles, std::int64_t tolerance);

/// The same where nothing is wrong but with those that have been `turned`, ascending.
std::vector<Violation> violations_of(const PlanarTriangles& triangles, std::int64_t tolerance,
                                     std::span<const std::uint32_t> turned);

/// How often rules that repair can satisfy are broken at stages model and display, the stages of its two promises.
std::size_t broken_rules(const validate::Context& context);

/// Faces that break a rule with a safe fix that is an error at one of the stages, ascending.
std::vector<scene::FaceId> faces_at_fault(const scene::Scene& scene,
                                          const std::optional<geom::ToleranceRequest>& tolerance,
                                          std::initializer_list<validate::Stage> stages);

}  // namespace rad::repair
