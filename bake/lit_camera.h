// Where to take the picture of a scene that is lit.
#pragma once

#include <span>

#include "bake/camera.h"
#include "bake/ray_scene.h"
#include "scene/vertex_light.h"

namespace rad::bake {

/// automatic_camera() of the light where it shows any. Where it shows the dark outside of a building, a view from
/// inside: from a lit floor, at eye height, in the direction in which most that is lit can be seen from farthest.
/// `shown` holds `triangles`, all of `scene`, as the picture will show them.
Camera lit_camera(const scene::Scene& scene, const scene::VertexLight& light, std::span<const DrawnTriangle> triangles,
                  const RayScene& shown, double aspect);

}  // namespace rad::bake
