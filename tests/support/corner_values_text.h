// What corners of faces have, to be compared in tests.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace rad::tests {

/// Texture coordinates of a face, loop by loop; empty where it has none.
inline std::vector<scene::dvec2> texture_of(const scene::Scene& scene, scene::FaceId face) {
  std::vector<scene::dvec2> values;
  for (const scene::Loop& loop : scene.loops_of(scene.faces[face])) {
    for (std::uint32_t corner = loop.first; corner < loop.first + loop.count; ++corner) {
      const scene::RowId row = scene.attributes.texture_coordinates.row(corner);
      if (row == scene::kNoRow) return {};
      values.push_back(scene.attributes.texture_coordinates.table[row]);
    }
  }
  return values;
}

/// Normals of a face, likewise.
inline std::vector<scene::dvec3> normals_of(const scene::Scene& scene, scene::FaceId face) {
  std::vector<scene::dvec3> values;
  for (const scene::Loop& loop : scene.loops_of(scene.faces[face])) {
    for (std::uint32_t corner = loop.first; corner < loop.first + loop.count; ++corner) {
      const scene::RowId row = scene.attributes.normals.row(corner);
      if (row == scene::kNoRow) return {};
      values.push_back(scene.attributes.normals.table[row]);
    }
  }
  return values;
}

}  // namespace rad::tests
