// A solution as one HTML file that shows it.
#pragma once

#include <string>

#include "scene/scene.h"
#include "scene/vertex_light.h"

namespace rad::report::html {

/// The scene in three dimensions as `light` has it, with its own exposure and curve at first; the reader of the page
/// changes both, and sees false colours, the edges of the faces, and radiosity where they click. Needs scripts, and
/// nothing of the network. `light` holds a value for each vertex. The same input gives the same bytes.
std::string viewer_page(const scene::Scene& scene, const scene::VertexLight& light, const std::string& title);

}  // namespace rad::report::html
