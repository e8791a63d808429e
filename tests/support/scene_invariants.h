// What holds of every Scene, however bad the model in it is.
#pragma once

#include <cstdint>
#include <string>

#include "scene/scene.h"

namespace rad::tests {

/// Whether faces have rows of a table at all of their corners or at none.
template <typename Value>
std::string broken_rows(const scene::Scene& scene, const scene::CornerValues<Value>& values) {
  if (values.empty()) return values.table.empty() ? "" : "a table without rows";
  if (values.row_of_corner.size() != scene.corners.size()) return "rows and corners differ in number";
  for (const scene::Face& face : scene.faces) {
    std::size_t corners = 0, named = 0;
    for (const scene::Loop& loop : scene.loops_of(face)) {
      for (std::uint32_t corner = loop.first; corner < loop.first + loop.count; ++corner, ++corners) {
        const scene::RowId row = values.row_of_corner[corner];
        if (row == scene::kNoRow) continue;
        if (row >= values.table.size()) return "a corner names no row";
        ++named;
      }
    }
    if (named != 0 && named != corners) return "a face has rows at some of its corners";
  }
  return "";
}

/// The first invariant of the raw model that this scene breaks, in words; empty for a sound one.
inline std::string broken_invariant(const scene::Scene& scene) {
  if (scene.materials.empty() || scene.objects.empty() || scene.groups.empty() || scene.entities.empty()) {
    return "no unnamed entry";
  }
  for (const scene::VertexId corner : scene.corners) {
    if (corner >= scene.vertices.size()) return "a corner names no vertex";
  }
  for (const scene::Loop& loop : scene.loops) {
    if (std::uint64_t{loop.first} + loop.count > scene.corners.size()) return "a loop reaches beyond the corners";
  }
  for (const scene::Face& face : scene.faces) {
    if (face.loop_count == 0) return "a face has no outer loop";
    if (std::uint64_t{face.first_loop} + face.loop_count > scene.loops.size()) return "a face names no loop";
    if (face.material >= scene.materials.size()) return "a face names no material";
    if (face.object >= scene.objects.size()) return "a face names no object";
    if (face.group >= scene.groups.size()) return "a face names no group";
    if (face.entity >= scene.entities.size()) return "a face names no entity";
    if (face.source.section >= scene.sections.size()) return "a face names no section of the source";
  }
  if (const std::string rows = broken_rows(scene, scene.attributes.texture_coordinates); !rows.empty()) return rows;
  if (const std::string rows = broken_rows(scene, scene.attributes.normals); !rows.empty()) return rows;
  const bool groups_fit = scene.smoothing_groups.empty() || scene.smoothing_groups.size() == scene.faces.size();
  if (!groups_fit) return "smoothing groups and faces differ in number";
  const bool records_fit = scene.vertex_records.empty() || scene.vertex_records.size() == scene.vertices.size();
  return records_fit ? "" : "vertex records and vertices differ in number";
}

}  // namespace rad::tests
