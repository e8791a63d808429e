// The light on the vertices of a scene, as a solution gives it and as a display shows it.
#pragma once

#include <string>
#include <vector>

#include "geom/vec.h"
#include "scene/display_curve.h"

namespace rad::scene {

/// Radiosity of every vertex of a scene and how it is shown. Colours are linear RGB:
/// colour = clamp(curved(exposure × radiosity), 0, 1).
struct VertexLight {
  std::vector<geom::dvec3> radiosity;  ///< W/m², own emission included; one for each vertex of the scene
  std::vector<geom::dvec3> colour;     ///< 0..1, linear; one for each vertex of the scene
  double exposure = 1;                 ///< m²/W
  DisplayCurve curve = DisplayCurve::Linear;
  double clamped_share = 0;            ///< share of the vertices with a channel above 1 before clamping
};

}  // namespace rad::scene
