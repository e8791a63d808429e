// Texture coordinates and normals of the input on a mesh of the repaired model.
#pragma once

#include <span>

#include "scene/conforming_model.h"
#include "scene/scene.h"

namespace rad::scene {

/// Gives the corners of `mesh` what `origin` has at their places. `model_face` names, for each face of the mesh, the
/// face of `model` that it is a part of; `model` was made from `origin`. Values go on affinely over the triangles of
/// the model.
void carry_attributes(Scene& mesh, std::span<const std::uint32_t> model_face, const ConformingModel& model,
                      const Scene& origin);

}  // namespace rad::scene
