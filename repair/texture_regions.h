// Which triangles may become one face although they have texture coordinates.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "repair/maximal_faces.h"

namespace rad::repair {

/// A number for each triangle: triangles of different numbers do not become one face. 0 where the source face has no
/// texture coordinates. Else the sources of one number are joined by `neighbours` and have, all of them, the texture
/// coordinates of one affine map, that of their largest member: so an error does not grow from face to face, and the
/// merged face loses no more than scene::TextureMap::fits allows. Larger faces choose first. A source that is not
/// affine itself stays alone. Nothing at all where no face of the scene has texture coordinates.
/// `neighbours`: pairs of triangles that could become one otherwise. `tolerance`: T in file units.
std::vector<std::uint32_t> texture_regions(const PlanarTriangles& triangles, const scene::Scene& scene,
                                           std::span<const std::array<std::uint32_t, 2>> neighbours, double tolerance);

}  // namespace rad::repair
