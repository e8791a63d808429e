// Where a picture is taken from.
#pragma once

#include <array>

#include "scene/scene.h"
#include "scene/vertex_light.h"

namespace rad::bake {

/// A pinhole camera. Where `up` is along the line of sight, another direction takes its place.
struct Camera {
  geom::dvec3 position{0, 0, 0};           ///< file units
  geom::dvec3 target{0, 0, -1};            ///< file units, the middle of the picture
  geom::dvec3 up{0, 1, 0};                 ///< any length but zero
  double vertical_field_of_view_deg = 35;  ///< between 0 and 180
};

/// The camera's axes, of unit length and at right angles.
struct CameraFrame {
  geom::dvec3 right;
  geom::dvec3 up;
  geom::dvec3 backward;
};
CameraFrame frame_of(const Camera& camera);

/// The direction that is up: what the scene states. Where it states nothing, Y or Z: the one along which the model
/// stands clear of zero while it is centred along the other; else the one with more area of faces at right angles to it
/// (floors, ceilings, table tops); else Z. A guess: tall furniture centred on zero lies down.
geom::dvec3 up_direction(const scene::Scene& scene);

/// The view from `direction`, of any length but zero, that just frames every vertex that faces use, for a picture with
/// this ratio of width to height.
Camera framing_camera(const scene::Scene& scene, const geom::dvec3& direction, double aspect);

/// Directions from the scene to the camera at this height above the horizon, first the one from which a front is seen
/// best.
std::array<geom::dvec3, 8> views_around(const geom::dvec3& up, double elevation_deg);

/// A three-quarter view from above that just frames every vertex that faces use, for a picture with this ratio of width
/// to height. Of eight such views it is the one that the most area faces: into a room that is open, or whose walls are
/// seen through from behind, and onto the front of furniture. With `light`, which holds a colour for each vertex, area
/// counts by the luminance that it shows: the view is of the lit sides.
Camera automatic_camera(const scene::Scene& scene, double aspect, const scene::VertexLight* light = nullptr);

}  // namespace rad::bake
