// The faces of a model as a format takes them, without repair.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "geom/tolerance.h"
#include "scene/scene.h"

namespace rad::cli {

struct ConvertedFaces {
  scene::Scene scene;
  std::size_t left_out = 0;  ///< faces that cannot be divided, having no inside
  std::string problem;       ///< why the model cannot be taken; then the rest means nothing
};

/// The scene itself, or, for formats of triangles, with every face that is no triangle or convex quad divided. Faces
/// with a corner that is not finite are left out.
ConvertedFaces faces_for(const scene::Scene& scene, bool triangles,
                         const std::optional<geom::ToleranceRequest>& tolerance);

}  // namespace rad::cli
