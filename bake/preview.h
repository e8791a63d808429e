// A picture of a scene, shaded or as it is lit.
#pragma once

#include <optional>

#include "bake/camera.h"
#include "bake/image.h"
#include "scene/scene.h"
#include "scene/vertex_light.h"

namespace rad::bake {

struct PreviewOptions {
  std::uint32_t width = 960;              ///< pixels
  std::uint32_t height = 720;             ///< pixels
  std::uint32_t samples_per_axis = 3;     ///< on a regular grid in each pixel; at least 1
  std::optional<Camera> camera;           ///< where none is given: automatic_camera(), with light lit_camera()
  bool cull_back_faces = true;            ///< see through faces from behind: into a room from outside
  bool outline_faces = false;             ///< draw the edges of the faces
  geom::dvec3 background{0.1, 0.1, 0.1};  ///< linear
};

/// The scene as the camera sees it. With `light`, which holds a colour for each vertex of the scene, colours are
/// interpolated linearly over the triangles of each face, and backs of faces, where they are seen, are black. Without,
/// faces are grey and shaded by a light at the camera, and backs are reddish. The same picture whatever the number of
/// threads. Only background where the camera's position, target and direction up leave no view.
Image render(const scene::Scene& scene, const scene::VertexLight* light, const PreviewOptions& options = {});

/// The camera that render() takes for a scene with light where none is given.
Camera light_camera(const scene::Scene& scene, const scene::VertexLight& light, double aspect);

}  // namespace rad::bake
