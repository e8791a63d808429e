// One ring for a face with holes: each hole is reached over a bridge that the ring runs along twice.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace rad::writers {

/// The corners of `face`, as indices into Scene::corners, as a single ring, holes turned against the outer loop.
/// Bridges join corners of the face, cross none of its edges and, where the face allows it, keep clear of its other
/// corners by 1e-4 of its diagonal. A face without holes, or with a corner that is not finite, gives its outer loop.
std::vector<std::uint32_t> bridged_ring(const scene::Scene& scene, const scene::Face& face);

}  // namespace rad::writers
